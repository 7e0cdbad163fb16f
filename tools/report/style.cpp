// SPDX-License-Identifier: Apache-2.0
#include "tools/report/page.hpp"

namespace legwright {

std::string_view report_style() {
  // No markup characters in here: the page must stay well-formed XML (so no child combinator
  // either).
  return R"(
:root { color-scheme: light dark; --paper: #fff; --ink: #1f2328; --pale: #59636e; --line: #d8dee4; --soft: #f6f8fa;
  --good: #1a7f37; --bad: #cf222e; --good-soft: #eaf6ec; --bad-soft: #fdf0ef;
  --c1: #1f6feb; --c2: #bc4c00; --c3: #1a7f37; --c4: #8250df; --c5: #0e8a9c; --c6: #a8326e; }
@media (prefers-color-scheme: dark) {
  :root { --paper: #14171c; --ink: #e4e8ed; --pale: #98a2ae; --line: #343b45; --soft: #1c2128;
    --good: #4ac26b; --bad: #ff7b72; --good-soft: #15251b; --bad-soft: #2c1a1b;
    --c1: #62a5ff; --c2: #f0924a; --c3: #4ac26b; --c4: #b794ff; --c5: #4cc9d8; --c6: #f08cc0; } }
* { box-sizing: border-box; }
body, h4 { overflow-wrap: break-word; } .stack .head, .stack td:not(.n) { overflow-wrap: anywhere; } .stack .head { min-width: 9rem; } .stack .mark { overflow-wrap: normal; } .stack .n small { white-space: normal; overflow-wrap: anywhere; }
html { -webkit-text-size-adjust: 100%; }
body { margin: 0 auto; padding: 2rem 1.25rem 4rem; max-width: 70rem; background: var(--paper); color: var(--ink);
  font: 16px/1.5 system-ui, -apple-system, "Segoe UI", Roboto, "Helvetica Neue", Arial, sans-serif; }
h1 { font-size: 1.9rem; line-height: 1.2; margin: 0; letter-spacing: -0.015em; overflow-wrap: anywhere; }
h2 { font-size: 1.25rem; margin: 0 0 .6rem; letter-spacing: -0.005em; }
h3 { font-size: 1rem; margin: 1.4rem 0 .3rem; }
header p { margin: .25rem 0 1.5rem; color: var(--pale); }
section { margin: 0 0 2.75rem; }
p { margin: .4rem 0; }
code { font: .88em ui-monospace, SFMono-Regular, Menlo, Consolas, monospace; overflow-wrap: anywhere; }
small { display: block; color: var(--pale); font-size: .8rem; line-height: 1.35; }
figcaption small { display: inline; font-weight: normal; }
em { display: block; font-style: normal; color: var(--c2); font-weight: 600; white-space: nowrap; }
.note { color: var(--pale); font-size: .92rem; }
.hint { background: var(--soft); border-left: 3px solid var(--c2); padding: .55rem .8rem; border-radius: 0 6px 6px 0; }
.cards { display: grid; grid-template-columns: repeat(2, minmax(0, 1fr)); gap: 1rem; }
@media (max-width: 40rem) { .cards { grid-template-columns: minmax(0, 1fr); } body { padding: 1.25rem 1rem 3rem; } }
.cards.many { grid-template-columns: repeat(auto-fit, minmax(min(17rem, 100%), 1fr)); } .many .verdict { font-size: 1.6rem; }
.card.t1 { border-top-color: var(--c1); } .card.t2 { border-top-color: var(--c2); } .card.t3 { border-top-color: var(--c3); }
.card.t4 { border-top-color: var(--c4); } .card.t5 { border-top-color: var(--c5); } .card.t6 { border-top-color: var(--c6); }
.runs td:last-child { min-width: 17rem; width: 45%; }
.ok { color: var(--good); font-weight: 600; } .no { color: var(--bad); font-weight: 600; }
.cards .note, .cards .hint { margin: 0; }
.cards p.hint, section p.wide { grid-column: 1 / -1; }
.card { border: 1px solid var(--line); border-top: 4px solid var(--pale); border-radius: 8px; padding: 1rem 1.2rem; }
.card h2 { font-size: .95rem; margin: 0; color: var(--pale); font-weight: 600; }
.card .verdict { font-size: 2rem; font-weight: 700; line-height: 1.15; margin: .1rem 0; letter-spacing: -0.02em; }
.card ul { margin: .5rem 0 0; padding-left: 1.1rem; }
.pass { border-top-color: var(--good); background: var(--good-soft); }
.fail { border-top-color: var(--bad); background: var(--bad-soft); }
.pass .verdict { color: var(--good); } .fail .verdict { color: var(--bad); }
figure { margin: 0; }
.strip { margin: 0 0 1.25rem; }
.strip figcaption { margin-bottom: .4rem; font-size: .92rem; color: var(--pale); } .strip b { color: var(--ink); }
.scroll { overflow-x: auto; -webkit-overflow-scrolling: touch; }
.strip img { display: block; width: 100%; min-width: 56rem; height: auto; border: 1px solid var(--line); border-radius: 6px; }
.moving { margin: 0 0 1.25rem; } .moving img { display: block; max-width: 100%; height: auto; border-radius: 6px; margin-top: .4rem; } .moving figcaption { font-size: .92rem; color: var(--pale); } .moving b { color: var(--ink); }
.only .terms td:nth-child(2), .only .terms th:nth-child(2), .only .share:first-child { display: none; }
.turned { margin: 0 0 2.75rem; } .turned[hidden] { display: none; } .turned figcaption { font-size: .92rem; color: var(--pale); margin-bottom: .4rem; } .turned b { color: var(--ink); } .stage3d { height: min(30rem, 80vh); border: 1px solid var(--line); border-radius: 8px; overflow: hidden; } @media print { .turned { display: none; } }
.gallery { display: grid; grid-template-columns: repeat(auto-fill, minmax(10rem, 1fr)); gap: .8rem; }
.gallery img { display: block; width: 100%; height: auto; border-radius: 6px; }
.gallery figcaption { font-size: .8rem; color: var(--pale); margin-top: .2rem; font-variant-numeric: tabular-nums; }
.charts { display: grid; grid-template-columns: repeat(auto-fit, minmax(min(26rem, 100%), 1fr)); gap: 1.75rem 2.5rem; margin-top: .8rem; }
.charts.tables { grid-template-columns: repeat(auto-fit, minmax(min(32rem, 100%), 1fr)); }
.charts div { min-width: 0; } .charts.single { grid-template-columns: minmax(0, 38rem); } .chart { min-width: 0; } .chart figcaption { font-weight: 600; font-size: .95rem; }
.chart svg { display: block; width: 100%; height: auto; margin-top: .3rem; }
.chart text { font: 12px system-ui, -apple-system, "Segoe UI", Roboto, sans-serif; fill: var(--pale); font-variant-numeric: tabular-nums; }
.grid { stroke: var(--line); stroke-width: 1; fill: none; } .axis, .tick { stroke: var(--pale); fill: none; }
.line { fill: none; stroke-width: 2; stroke-linejoin: round; stroke-linecap: round; } .line.dash { stroke-dasharray: 6 5; }
.line.fine { stroke-width: 1; opacity: .75; } .c0 { stroke: var(--pale); } .f0 { fill: var(--pale); } .key.b0 { border-color: var(--pale); }
.c1 { stroke: var(--c1); } .c2 { stroke: var(--c2); } .c3 { stroke: var(--c3); } .c4 { stroke: var(--c4); } .c5 { stroke: var(--c5); } .c6 { stroke: var(--c6); }
.f1 { fill: var(--c1); } .f2 { fill: var(--c2); } .f3 { fill: var(--c3); } .f4 { fill: var(--c4); } .f5 { fill: var(--c5); } .f6 { fill: var(--c6); }
.legend { margin: .15rem 0 0; font-size: .82rem; color: var(--pale); } .legend span { margin-right: .9rem; white-space: nowrap; }
.key { display: inline-block; width: 1.3rem; border-top: 3px solid; vertical-align: middle; margin-right: .35rem; } .key.dash { border-top-style: dashed; }
.key.b1 { border-color: var(--c1); } .key.b2 { border-color: var(--c2); } .key.b3 { border-color: var(--c3); }
.key.b4 { border-color: var(--c4); } .key.b5 { border-color: var(--c5); } .key.b6 { border-color: var(--c6); }
.key.wide { border-top-width: 12px; border-color: var(--c1); opacity: .3; border-radius: 2px; } .key.thin { border-top-width: 5px; border-color: var(--ink); }
.band { opacity: .22; } .chart.wide { margin: .8rem 0 1.4rem; } h4 { font-size: .85rem; margin: .4rem 0 0; font-weight: 600; }
.multiples { display: grid; grid-template-columns: repeat(auto-fill, minmax(14rem, 1fr)); gap: .2rem 1.2rem; } .multiples div { min-width: 0; }
.key.area { border-top-width: 12px; opacity: .4; border-radius: 2px; } .key.bad-key { border-color: var(--bad); } .key.dot { width: .7rem; height: .7rem; border: 0; border-radius: 50%; background: var(--ink); }
.range { display: block; width: 100%; height: auto; } .range .walks { fill: var(--good); opacity: .55; } .range .falls { fill: var(--bad); opacity: .35; }
.range .end { stroke: var(--ink); stroke-width: 1.5; fill: none; } .range .nominal { fill: var(--ink); stroke: var(--paper); stroke-width: 1.5; }
.ends { display: flex; justify-content: space-between; margin: 0; font-size: .78rem; color: var(--pale); font-variant-numeric: tabular-nums; }
.margin { width: 22rem; min-width: 12rem; } .margins td:first-child { min-width: 10rem; } .survival { max-width: 38rem; } .failed td { background: var(--bad-soft); }
.limits .mark { padding-left: .4rem; } .pair .margin { width: 38%; }
.planned { fill: var(--c1); opacity: .28; } .measured { fill: var(--ink); }
table { border-collapse: collapse; width: 100%; font-size: .92rem; }
th, td { text-align: left; padding: .4rem .9rem .4rem 0; border-bottom: 1px solid var(--line); vertical-align: top; }
th { font-size: .8rem; color: var(--pale); font-weight: 600; white-space: nowrap; } td b { font-weight: 600; }
.n { text-align: right; white-space: nowrap; font-variant-numeric: tabular-nums; }
.design td:first-child { min-width: 11rem; } .bar { width: 12rem; min-width: 9rem; } .bounds { display: block; width: 100%; max-width: 11rem; height: auto; }
.track { stroke: var(--line); stroke-width: 2; fill: none; } .moved { stroke: var(--c1); stroke-width: 3; fill: none; opacity: .55; }
.before { fill: var(--paper); stroke: var(--pale); stroke-width: 1.5; } .after { fill: var(--c1); }
.bars { width: 40%; min-width: 7rem; padding-top: .7rem; } .share { display: block; width: 100%; height: 6px; margin-bottom: 3px; }
.share .b1 { fill: var(--c1); } .share .b2 { fill: var(--c2); } .sum td { font-weight: 700; }
.gains td:first-child { min-width: 11rem; overflow-wrap: anywhere; } .changes { margin: .3rem 0 0; padding-left: 1.3rem; } .origin td:first-child { white-space: nowrap; color: var(--pale); width: 1%; }
.why { color: var(--ink); } .mark { width: 1.6rem; font-weight: 700; } .good { color: var(--good); } .bad { color: var(--bad); }
a { color: var(--c1); } .proof .n { padding-right: 0; } .proof td:nth-child(2) { width: 100%; }
details { margin: 1.2rem 0 0; } summary { cursor: pointer; font-weight: 600; font-size: .95rem; } details table { margin-top: .5rem; }
.matrix td, .matrix th { padding-right: 1.2rem; } .matrix td:first-child { min-width: 8rem; }
.matrix p { margin: 0 0 .2rem; } .matrix p b { margin-right: .5rem; font-variant-numeric: tabular-nums; } .matrix .cell { padding-left: .7rem; border-left: 3px solid var(--line); }
.matrix th + th { padding-left: .85rem; } .matrix .good-cell { background: var(--good-soft); border-left-color: var(--good); } .matrix .bad-cell { background: var(--bad-soft); border-left-color: var(--bad); }
dl { display: flex; flex-wrap: wrap; gap: .1rem 1.1rem; margin: 0; font-size: .85rem; color: var(--pale); } dl div { white-space: nowrap; }
dt { display: inline; } dt::after { content: " "; } dd { display: inline; margin: 0 0 0 .25rem; color: var(--ink); font-variant-numeric: tabular-nums; }
.chosen td:first-child { border-left: 3px solid var(--c1); padding-left: .6rem; } .limit { white-space: nowrap; } .reason { font-size: .88rem; min-width: 14rem; } .pulls b { white-space: nowrap; }
.key.ring { width: .85rem; height: .85rem; border-width: 2px; border-style: solid; border-radius: 50%; }
footer { color: var(--pale); font-size: .85rem; border-top: 1px solid var(--line); padding-top: .8rem; }
@media (max-width: 40rem) {
  .design, .design tbody { display: block; } .design thead { display: none; }
  .design tr { display: grid; grid-template-columns: 1fr 1fr 1fr; border-bottom: 1px solid var(--line); padding: .5rem 0; }
  .design td { border: 0; padding: .1rem 0; text-align: left; } .design td:first-child, .design .bar { grid-column: 1 / -1; width: auto; }
  .design .n::before { content: attr(data-label); display: block; color: var(--pale); font-size: .8rem; line-height: 1.2; }
  .bodies tr { grid-template-columns: 1fr 1fr; } .design .reason { grid-column: 1 / -1; padding-top: .3rem; }
  .stack, .stack tbody { display: block; } .stack thead { display: none; }
  .stack tr { display: grid; grid-template-columns: repeat(3, 1fr); gap: .15rem .6rem; border-bottom: 1px solid var(--line); padding: .5rem 0; }
  .stack td { border: 0; padding: 0; text-align: left; white-space: normal; min-width: 0 !important; overflow-wrap: anywhere; } .stack .head, .stack .margin, .stack .bar { grid-column: 1 / -1; width: auto; }
  .stack td[data-label]::before { content: attr(data-label); display: block; color: var(--pale); font-size: .78rem; line-height: 1.25; }
  .limits.stack:not(.pair) tr { position: relative; padding-left: 1.6rem; } .limits .mark { position: absolute; left: .2rem; top: .5rem; }
  .gains { font-size: .84rem; } .gains td:first-child { min-width: 0; } .gains td, .gains th { padding-right: .45rem; white-space: normal; }
  .multiples { grid-template-columns: repeat(auto-fill, minmax(9.5rem, 1fr)); gap: .2rem .6rem; } .margins td:last-child { grid-column: 1 / -1; } .origin.stack tr { grid-template-columns: 1fr; }
  .matrix, .matrix tbody { display: block; } .matrix thead { display: none; } .matrix tr { display: grid; grid-template-columns: repeat(auto-fit, minmax(8rem, 1fr)); gap: 2px; padding: .5rem 0; border-bottom: 1px solid var(--line); }
  .matrix td { border-bottom: 0; padding: .3rem .5rem; } .matrix td:first-child { grid-column: 1 / -1; } .matrix .cell::before { content: attr(data-label); color: var(--pale); font-size: .8rem; }
  .matrix p b { display: block; } dl { display: block; } .starts td:first-child { min-width: 8.5rem; }
  .bounds { max-width: 14rem; } .terms small { display: none; } .terms .bars { padding-top: .9rem; } }
@media print { html { font-size: 11px; } body { max-width: none; padding: 0; font-size: 9.5pt; } figure, tr, .card, li { break-inside: avoid; } h2, h3, h4, summary, thead, figcaption { break-after: avoid; } section { margin-bottom: 1.6rem; }
  .charts { grid-template-columns: 1fr 1fr; gap: 1rem 1.6rem; } .charts.single { grid-template-columns: 60%; } .multiples { grid-template-columns: repeat(4, 1fr); } .chart text { font-size: 11px; } .moving img { max-width: 50%; }
  .strip img { min-width: 0; } .scroll { overflow: visible; } summary { list-style: none; } details::details-content { content-visibility: visible; block-size: auto; } }
)";
}

}  // namespace legwright
