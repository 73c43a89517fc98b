# SPDX-FileCopyrightText: 2026 The clothfit authors
# SPDX-License-Identifier: Apache-2.0
#
# How Sphinx makes a site of these pages; tools/manual calls it, on a copy of the pages.
project = "clothfit"
author = "The clothfit authors"
copyright = "2026, The clothfit authors"

extensions = ["myst_parser"]
myst_enable_extensions = ["colon_fence", "deflist"]
myst_heading_anchors = 4
exclude_patterns = ["docs/README.md"]
master_doc = "docs/index"

html_theme = "furo"
html_title = "clothfit"
html_copy_source = False
html_show_sphinx = False
# Debian's furo comes without its colours by night.
html_theme_options = {
    "navigation_with_keys": True,
    "dark_css_variables": {
        "color-foreground-primary": "#eceef0",
        "color-foreground-secondary": "#b4bcc4",
        "color-foreground-muted": "#8c959e",
        "color-foreground-border": "#5a636d",
        "color-background-primary": "#101316",
        "color-background-secondary": "#181c20",
        "color-background-hover": "#262c32",
        "color-background-hover--transparent": "#262c3200",
        "color-background-border": "#2b3137",
        "color-background-item": "#262c32",
        "color-brand-primary": "#6cb8f5",
        "color-brand-content": "#6cb8f5",
        "color-highlighted-background": "#083563",
        "color-inline-code-background": "#181c20",
        "color-admonition-background": "#181c20",
        "color-card-background": "#181c20",
        "color-card-border": "#2b3137",
    },
}
pygments_style = "default"
nitpicky = True
suppress_warnings = ["myst.header"]  # levels that a page passes over
