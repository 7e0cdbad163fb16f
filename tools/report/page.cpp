// SPDX-License-Identifier: Apache-2.0
#include "tools/report/page.hpp"

#include "tools/report/sections.hpp"

namespace legwright {

void open_page(Html& page, const std::string& title, const std::string& line) {
  page.raw("<!DOCTYPE html>\n").open("html", {{"lang", "en"}}).open("head");
  page.lone("meta", {{"charset", "utf-8"}});
  page.lone("meta",
            {{"http-equiv", "Content-Security-Policy"},
             {"content",
              "default-src 'none'; img-src data:; style-src 'unsafe-inline'; base-uri 'none'; "
              "form-action 'none'"}});
  page.lone("meta", {{"name", "viewport"}, {"content", "width=device-width, initial-scale=1"}});
  page.lone("meta", {{"name", "color-scheme"}, {"content", "light dark"}});
  page.element("title", title);
  page.open("style").raw(report_style()).close().close();
  page.open("body").open("header").element("h1", title).element("p", line).close();
  page.open("main");
}

void close_page(Html& page, const std::string& footer, const std::string& id,
                const std::string& json) {
  page.close().element("footer", footer);
  page.open("script", {{"type", "application/json"}, {"id", id}});
  page.raw(escape_json_island(json)).close();
  page.close().close();
}

void close_page(Html& page, const Json& island) {
  close_page(
      page,
      "Made by legwright report from the files of this run; nothing is fetched from elsewhere.",
      "legwright-report", to_text(island));
}

Json island_of(const RunData& data) {
  Json island{{"schema", "legwright/report"}, {"version", 1}};
  const RunRecord& run = data.run;
  island["robot"] = run.robot;
  island["task"] = run.task ? json_of(*run.task) : Json();
  island["status"] = run.status;
  island["motion_only_F"] = or_null(run.motion_only_F);
  island["final_F"] = or_null(run.final_F);
  island["parameters"] = json_of(run.parameters);
  return island;
}

}  // namespace legwright
