// SPDX-License-Identifier: Apache-2.0
#include "tools/report/page.hpp"

#include <fmt/format.h>

#include "tools/report/page_viewer.hpp"

namespace legwright {

std::string framed_page(const PageFrame& frame, const std::function<void(Html&)>& sections) {
  const ViewerScripts scripts =
      frame.scenes.empty() ? ViewerScripts{"", "'none'"} : viewer_scripts(frame.scenes);
  const std::string policy = fmt::format(
      "default-src 'none'; img-src data:; style-src 'unsafe-inline'; script-src {}; "
      "base-uri 'none'; form-action 'none'",
      scripts.policy);
  Html page;
  page.raw("<!DOCTYPE html>\n").open("html", {{"lang", "en"}}).open("head");
  page.lone("meta", {{"charset", "utf-8"}});
  page.lone("meta", {{"http-equiv", "Content-Security-Policy"}, {"content", policy}});
  page.lone("meta", {{"name", "viewport"}, {"content", "width=device-width, initial-scale=1"}});
  page.lone("meta", {{"name", "color-scheme"}, {"content", "light dark"}});
  page.element("title", frame.title);
  page.open("style").raw(report_style()).close().close();
  page.open("body").open("header").element("h1", frame.title).element("p", frame.line).close();
  page.open("main");
  sections(page);
  page.close().element("footer", frame.footer);
  page.open("script", {{"type", "application/json"}, {"id", frame.id}});
  page.raw(escape_json_island(to_text(frame.island))).close();
  page.raw(scripts.markup).close().close();
  return page.take();
}

}  // namespace legwright
