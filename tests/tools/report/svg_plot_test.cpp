// SPDX-License-Identifier: Apache-2.0
#include "tools/report/svg_plot.hpp"

#include <gtest/gtest.h>
#include <tinyxml2.h>

#include <cmath>
#include <limits>

#include "tests/support/text.hpp"
#include "tests/tools/report/hostile_names.hpp"

namespace legwright {
namespace {

bool well_formed(const std::string& markup) {
  tinyxml2::XMLDocument document;
  return document.Parse(("<div>" + markup + "</div>").c_str()) == tinyxml2::XML_SUCCESS;
}

TEST(LinearTicks, AreRoundAndInside) {
  const auto ticks = linear_ticks(0.0, 1.0, 5);
  ASSERT_EQ(ticks.size(), 6U);
  EXPECT_DOUBLE_EQ(ticks[1], 0.2);
  EXPECT_DOUBLE_EQ(ticks.back(), 1.0);
  for (const double tick : linear_ticks(-0.037, 0.113, 6)) {
    EXPECT_GE(tick, -0.037);
    EXPECT_LE(tick, 0.113);
    EXPECT_NEAR(std::remainder(tick, 0.05), 0.0, 1e-12);
  }
}

TEST(LinearTicks, AreWholeWhereAsked) {
  for (const double tick : linear_ticks(0.0, 3.0, 10, true)) EXPECT_EQ(tick, std::round(tick));
  EXPECT_EQ(linear_ticks(0.0, 3.0, 10, true).size(), 4U);
  EXPECT_GT(linear_ticks(0.0, 3.0, 10, false).size(), 4U);  // the flag makes the difference
}

TEST(LinearTicks, SurviveAnEmptyRange) {
  EXPECT_EQ(linear_ticks(2.0, 2.0, 5), std::vector<double>{2.0});
  EXPECT_EQ(linear_ticks(0.0, std::numeric_limits<double>::infinity(), 5).size(), 1U);
}

TEST(LogTicks, ArePowersOfTen) {
  const auto ticks = log_ticks(0.02, 5000.0);
  ASSERT_EQ(ticks.size(), 5U);
  EXPECT_NEAR(ticks.front(), 0.1, 1e-12);
  EXPECT_NEAR(ticks.back(), 1000.0, 1e-9);
  const auto narrow = log_ticks(3.0, 40.0);  // 5, 10, 20
  ASSERT_EQ(narrow.size(), 3U);
  EXPECT_NEAR(narrow[0], 5.0, 1e-12);
  EXPECT_LE(log_ticks(1e-30, 1e30).size(), 8U);
}

TEST(TickLabel, ReadsLikePeopleWrite) {
  EXPECT_EQ(tick_label(0.0), "0");
  EXPECT_EQ(tick_label(0.25), "0.25");
  EXPECT_EQ(tick_label(1000.0), "1000");
  EXPECT_EQ(tick_label(-2.5), "−2.5");
  EXPECT_EQ(tick_label(1e-7), "1e-07");
}

TEST(LinePlot, PutsTheLargerValueHigher) {
  const auto y_of_circles = [](const std::string& svg) {
    std::vector<double> y;
    for (std::size_t at = svg.find("cy=\""); at != std::string::npos;
         at = svg.find("cy=\"", at + 1)) {
      y.push_back(std::stod(svg.substr(at + 4)));
    }
    return y;
  };
  for (const bool log : {false, true}) {
    const auto y =
        y_of_circles(line_plot({{.name = "F", .x = {0, 1, 2}, .y = {100, 10, 1}, .points = true}},
                               {.title = "F", .log_y = log}));
    ASSERT_EQ(y.size(), 3U);
    EXPECT_LT(y[0], y[1]);
    EXPECT_LT(y[1], y[2]);
    EXPECT_EQ(std::abs((y[1] - y[0]) - (y[2] - y[1])) < 0.2,
              log);  // only a log scale spaces these evenly
  }
}

TEST(LinePlot, BreaksTheLineWhereThereIsNoNumber) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const auto svg =
      line_plot({{.name = "a", .x = {0, 1, 2, 3}, .y = {1, nan, 2, 3}}}, {.title = "t"});
  EXPECT_EQ(svg.find("nan"), std::string::npos);
  const auto at = svg.find("class=\"line");
  EXPECT_EQ(count_of(svg.substr(at, svg.find("/>", at) - at), "M"), 2U);
}

TEST(LinePlot, SaysSoWhereThereIsNothing) {
  EXPECT_NE(line_plot({}, {.title = "t"}).find("Nothing to draw"), std::string::npos);
  EXPECT_NE(line_plot({{.name = "a", .x = {0, 1}, .y = {-1, 0}}}, {.title = "t", .log_y = true})
                .find("Nothing"),
            std::string::npos);
}

TEST(LinePlot, IsWellFormedWhateverItsNames) {
  for (const std::string& name : hostile_names()) {
    const PlotSeries a{.name = name, .x = {0, 1}, .y = {1, 2}};
    EXPECT_TRUE(well_formed(line_plot({a, a}, {.title = name, .x_label = name, .y_label = name})))
        << name;
    EXPECT_TRUE(well_formed(footfall_plot({{name, {{0.0, 0.5}}, {{0.1, 0.6}}}}, 1.0, name)))
        << name;
  }
}

TEST(FootfallPlot, DrawsEachSpanOnceAndCutsAtTheEnd) {
  const auto svg = footfall_plot({{"FL", {{-0.2, 0.5}, {1.2, 1.4}}, {{0.1, 2.0}}}}, 1.0, "t");
  EXPECT_EQ(count_of(svg, "class=\"planned\""), 1U);
  EXPECT_EQ(count_of(svg, "class=\"measured\""), 1U);
}

TEST(FootfallPlot, LongNamesStandThereWholeWithinTheDrawing) {
  const auto name_end = [](const std::string& name) {
    const std::string svg = footfall_plot({{name, {{0.0, 0.5}}, {}}}, 1.0, "t");
    EXPECT_EQ(count_of(svg, ">" + name + "<"), 1U) << name;
    return std::stod(svg.substr(svg.find("<text x=\"") + 9));
  };
  EXPECT_EQ(name_end("FL"), 54.0);
  EXPECT_GT(name_end("hoof_front_left"), 15 * 6.0) << "room for each letter";
  const std::string endless(200, 'x');
  EXPECT_EQ(count_of(footfall_plot({{endless, {}, {}}}, 1.0, "t"), "xxx…<"), 1U);
}

TEST(LinePlot, ABandLiesBetweenItsEdgesAndBreaksWhereThereIsNoNumber) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  PlotSeries band{.name = "band", .x = {0, 1, 2, 3, 4}};
  band.low = {0, 0, nan, 0, 0};
  band.high = {1, 2, 2, 2, 1};
  const auto svg =
      line_plot({band, {.name = "mean", .x = {0, 4}, .y = {0.5, 0.5}}}, {.title = "t"});
  const auto at = svg.find("class=\"band f1\"");
  ASSERT_NE(at, std::string::npos);
  EXPECT_EQ(count_of(svg.substr(at, svg.find("/>", at) - at), "Z"), 2U);
  EXPECT_EQ(svg.find("nan"), std::string::npos);
  EXPECT_NE(svg.find("key b1 area"), std::string::npos);
  EXPECT_EQ(count_of(svg, "class=\"line"), 1U) << "a band without y has no line";
}

TEST(PlotRange, CoversTheBand) {
  PlotSeries band{.name = "band", .x = {0, 1}};
  band.low = {-5, -4};
  band.high = {4, 7};
  const auto range = plot_range({band}, {});
  ASSERT_TRUE(range);
  EXPECT_LE(range->y_low, -5.0);
  EXPECT_GE(range->y_high, 7.0);
  EXPECT_FALSE(plot_range({{.name = "none"}}, {}));
}

TEST(PlotRange, EqualAxesGiveBothTheSameScale) {
  const PlotSeries path{.name = "path", .x = {0, 0.1}, .y = {0, 2}};
  const PlotOptions options{.x_label = "x", .equal_axes = true};
  const auto range = plot_range({path}, options);
  ASSERT_TRUE(range);
  const double wide = options.width - 52 - 12, high = options.height - 10 - 42;
  EXPECT_NEAR((range->x_high - range->x_low) / wide, (range->y_high - range->y_low) / high, 1e-12);
}

TEST(PlotRange, SmallChangesStaySmall) {
  const PlotSeries noise{.name = "noise", .x = {0, 1}, .y = {5.0, 5.001}};
  const auto range = plot_range({noise}, {.least_height = 2.0});
  ASSERT_TRUE(range);
  EXPECT_NEAR(range->y_high - range->y_low, 2.0, 1e-9);
}

TEST(SmallMultiples, ShareOneRangeAndOneLegend) {
  const auto panel = [](const std::string& name, double most) {
    return PlotPanel{name,
                     {{.name = "a", .x = {0, 1}, .y = {0, most}, .points = true},
                      {.name = "b", .x = {0, 1}, .y = {0, 1}}}};
  };
  const auto top = [](const std::string& svg, const std::string& name) {
    const auto at = svg.find("cy=\"", svg.find("cy=\"", svg.find("t, " + name)) + 1);
    return std::stod(svg.substr(at + 4));
  };
  const auto svg = small_multiples({panel("FL", 1.0), panel("FR", 10.0), {"none", {}}},
                                   {.title = "t", .width = 220, .height = 150});
  EXPECT_TRUE(well_formed(svg));
  EXPECT_EQ(count_of(svg, "<svg"), 2U) << "nothing to draw, no panel";
  EXPECT_EQ(count_of(svg, "class=\"legend\""), 1U);
  EXPECT_GT(top(svg, "FL"), top(svg, "FR") + 50) << "the smaller one stays lower";
  EXPECT_NE(small_multiples({}, {.title = "t"}).find("Nothing to draw"), std::string::npos);
  for (const std::string& name : hostile_names())
    EXPECT_TRUE(well_formed(small_multiples({panel(name, 1.0)}, {.title = name, .y_label = name})));
}

TEST(LinePlot, AMarkIsARingWithoutALine) {
  PlotSeries line{.name = "curve", .x = {1, 2}, .y = {3, 4}};
  PlotSeries mark{.name = "design", .x = {2}, .y = {4}, .colour = 3, .mark = true};
  const std::string plot = line_plot({line, mark}, {.title = "front"});
  EXPECT_NE(plot.find("<circle class=\"line c3\""), std::string::npos);
  EXPECT_EQ(plot.find("<path class=\"line c3"), std::string::npos);
  EXPECT_NE(plot.find("key b3 ring"), std::string::npos);
  EXPECT_EQ(line_plot({line}, {}).find("<circle"), std::string::npos);
}

}  // namespace
}  // namespace legwright
