// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
#include "fitting/report/page/html.h"

#include <algorithm>

#include <fmt/format.h>

#include "autodiff_sim/base/printable.h"
#include "fitting/files/sha256.h"
#include "fitting/report/page/packing.h"

namespace clothfit {
namespace {

using Json = ReportBlobs::Json;

// No page of ours may ask for anything from anywhere, nor run any script but the one that is its
// own: names in it may be a stranger's.
std::string Policy(std::string_view script) {
  const std::string digits = Sha256(script);
  std::string digest;
  for (std::size_t i = 0; i < digits.size(); i += 2)
    digest += static_cast<char>(std::stoi(digits.substr(i, 2), nullptr, 16));
  return "default-src 'none'; script-src 'sha256-" + Base64(digest) +
         "'; style-src 'unsafe-inline'; img-src data: blob:; base-uri 'none'; form-action 'none'";
}

// Before and after in words, with a bar for what is left of the error.
std::string ErrorCell(const Json& error) {
  const std::string unit = error.at("unit");
  const auto in_words = [&](const char* key) {
    return error.at(key).is_null() ? std::string("?")
                                   : QuantityInWords(error.at(key).get<double>(), unit);
  };
  std::string gauge;
  if (error.at("before").is_number() && error.at("after").is_number()) {
    const double before = error.at("before"), after = error.at("after");
    const double largest = std::max({before, after, 1e-300});
    gauge = fmt::format(
        "<span class=\"gauge\" aria-hidden=\"true\"><span class=\"was\" style=\"width: {:.1f}%\">"
        "</span><span class=\"is\" style=\"width: {:.1f}%\"></span></span>",
        100.0 * before / largest, 100.0 * after / largest);
  }
  if (error.at("after").is_null())
    return fmt::format("<strong>{}</strong>", EscapeHtml(in_words("before")));
  return fmt::format("<span class=\"was\">{}</span> → <strong>{}</strong>{}",
                     EscapeHtml(in_words("before")), EscapeHtml(in_words("after")), gauge);
}

// A row a kind of observation, fitted and held out.
std::string ErrorTable(const Json& errors) {
  std::string rows;
  for (const char* kind : {"markers", "tracks", "clouds", "silhouettes"}) {
    std::string cells[2] = {"–", "–"};
    bool is_known = false;
    for (const Json& error : errors) {
      if (error.at("kind") != kind) continue;
      cells[error.at("held_out") == true ? 1 : 0] = ErrorCell(error);
      is_known = true;
    }
    if (!is_known) continue;
    // Of outlines the error is an area, not a distance.
    const std::string title = std::string(kind) == "silhouettes" ? "outlines, area" : kind;
    rows += fmt::format("<tr><th scope=\"row\">{}</th><td>{}</td><td>{}</td></tr>\n", title,
                        cells[0], cells[1]);
  }
  return rows;
}

// Before and after, where the page has errors to show.
std::string ErrorNumbers(const Json& json) {
  if (!json.contains("errors") || json.at("errors").empty()) return "";
  return fmt::format(
      "<div class=\"verdict-numbers\"><table class=\"errors\"><caption>{}</caption>\n"
      "<tr><td></td><th scope=\"col\">fitted</th><th scope=\"col\">held out</th></tr>\n"
      "{}</table></div>\n",
      EscapeHtml(json.at("errors_title").get<std::string>()), ErrorTable(json.at("errors")));
}

std::string Hero(const Json& json, const PageVerdict& verdict) {
  std::string sentences;
  for (const std::string& sentence : verdict.sentences) {
    sentences += "<li>" + EscapeHtml(sentence) + "</li>\n";
  }
  return fmt::format(
      "<header class=\"bar\"><span class=\"brand\">clothfit</span>"
      "<span class=\"recording\">{}</span><span id=\"bar-tools\"></span></header>\n"
      "<main>\n<section class=\"verdict\" id=\"verdict\" data-grade=\"{}\">\n"
      "<div class=\"verdict-words\"><h1>{}</h1>\n<ul>\n{}</ul></div>\n{}</section>\n"
      "<section id=\"stage\" aria-label=\"The cloth beside the recording\">"
      "<noscript><p>The moving pictures and the charts of this page need scripts.</p></noscript>"
      "</section>\n<div id=\"sections\"></div>\n</main>\n",
      EscapeHtml(json.at("title").get<std::string>()), ToString(verdict.grade),
      EscapeHtml(verdict.headline), sentences, ErrorNumbers(json));
}

// Whether \uXXXX turns the direction of writing, so that what is shown is not what stands there.
bool TurnsWriting(std::string_view escape) {
  constexpr std::string_view kTurning[] = {"\\u200e", "\\u200f", "\\u061c", "\\u202a",
                                           "\\u202b", "\\u202c", "\\u202d", "\\u202e",
                                           "\\u2066", "\\u2067", "\\u2068", "\\u2069"};
  return std::find(std::begin(kTurning), std::end(kTurning), escape) != std::end(kTurning);
}

// JSON in a script element must not hold "</script" or "<!--". All in ASCII; what turns the
// direction of writing is shown as its number.
std::string JsonForScript(const Json& json) {
  const std::string text = json.dump(-1, ' ', true, Json::error_handler_t::replace);
  std::string safe;
  safe.reserve(text.size());
  for (std::size_t i = 0; i < text.size(); ++i) {
    if (text[i] == '<') {
      safe += "\\u003c";
    } else if (text[i] == '\\') {  // always of two characters or, with u, of six
      if (TurnsWriting(std::string_view(text).substr(i, 6))) safe += '\\';
      safe += text[i];
      safe += text[++i];
    } else {
      safe += text[i];
    }
  }
  return safe;
}

}  // namespace

std::string EscapeHtml(std::string_view text) {
  std::string html;
  for (const char c : Printable(text, text.size() * 8 + 1)) {
    switch (c) {
      case '\'':
        html += "&#39;";
        break;
      case '&':
        html += "&amp;";
        break;
      case '<':
        html += "&lt;";
        break;
      case '>':
        html += "&gt;";
        break;
      case '"':
        html += "&quot;";
        break;
      default:
        html += c;
    }
  }
  return html;
}

std::string ReportAsHtml(const Json& json, const PageVerdict& verdict, const ReportBlobs& blobs,
                         const ReportAssets& assets) {
  std::string html = fmt::format(
      "<!doctype html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\">\n"
      "<meta http-equiv=\"Content-Security-Policy\" content=\"{}\">\n"
      "<meta name=\"viewport\" content=\"width=device-width, initial-scale=1\">\n"
      "<meta name=\"generator\" content=\"clothfit {}\">\n<title>{} · clothfit</title>\n<style>",
      Policy(assets.script), EscapeHtml(json.at("version").get<std::string>()),
      EscapeHtml(json.at("title").get<std::string>()));
  html += assets.style;
  html += "</style>\n</head>\n<body>\n" + Hero(json, verdict);
  html +=
      "<script type=\"application/json\" id=\"report-data\">" + JsonForScript(json) + "</script>\n";
  for (std::size_t i = 0; i < blobs.blobs().size(); ++i) {
    html += fmt::format("<script type=\"text/plain\" id=\"blob-{}\">", i);
    html += Base64(blobs.blobs()[i]);
    html += "</script>\n";
  }
  html += "<script>";
  html += assets.script;
  html += "</script>\n</body>\n</html>\n";
  return html;
}

}  // namespace clothfit
