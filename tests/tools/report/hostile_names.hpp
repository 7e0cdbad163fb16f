// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

namespace legwright {

/// Names as somebody who means harm, or a careless tool, might give a joint, a foot or a task.
inline std::vector<std::string> hostile_names() {
  return {
      "<script>alert(1)</script>",
      "</script><script>alert(1)</script>",
      "</SCRIPT >x",
      "</style><b>x",
      "</title><h1>x",
      "<img src=x onerror=alert(1)>",
      "\"><svg onload=alert(1)>",
      "' onmouseover='alert(1)",
      "\" onfocus=\"alert(1)\" autofocus=\"",
      "` onclick=`alert(1)",
      "<!-- x",
      "--> x",
      "<!--<script>",
      "]]> x",
      "<![CDATA[x]]>",
      "<?xml version=\"1.0\"?>",
      "<!DOCTYPE x [<!ENTITY y SYSTEM 'file:///etc/passwd'>]>",
      "&y;",
      "&amp;",
      "&#60;b&#62;",
      "&lt;b&gt;",
      "javascript:alert(1)",
      "data:text/html,<b>x",
      "http://example.org/x.png",
      "<a href=https://example.org>x</a>",
      "<link rel=stylesheet href=//example.org/x.css>",
      "<iframe srcdoc='x'>",
      "<base href=//example.org/>",
      "<meta http-equiv=refresh content=0>",
      "{{constructor.constructor('x')()}}",
      "${alert(1)}",
      "\\\"; alert(1); //",
      "\\u003cscript\\u003e",
      std::string("zero\0byte", 9),
      "bell\x07 escape\x1b[31m red",
      "bad \xC3\x28 utf-8",
      "overlong \xC0\xBCscript\xC0\xBE",
      "torn \xE2\x82",
      "surrogate \xED\xA0\x80",
      "right to left \xE2\x80\xAE txt.exe",
      "line separator \xE2\x80\xA8 here",
      "byte order mark \xEF\xBB\xBF",
      "a|b|c",
      "[x](javascript:alert(1))",
      "../../etc/passwd",
      "name with spaces and 'quotes' and \"double\" ones",
      "%s %n %x",
      "<svg><script>x</script></svg>",
      "x\r\nSet-Cookie: y",
      std::string(300, '<'),
  };
}

}  // namespace legwright
