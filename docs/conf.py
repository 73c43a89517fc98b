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
html_theme_options = {"source_repository": "", "navigation_with_keys": True}
pygments_style = "default"
nitpicky = True
suppress_warnings = ["myst.header"]  # levels that a page passes over
