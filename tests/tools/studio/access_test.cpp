// SPDX-License-Identifier: Apache-2.0
#include "tools/studio/access.hpp"

#include <gtest/gtest.h>

namespace legwright {
namespace {

TEST(AccessTest, EachStudioHasATokenOf128Bits) {
  const AccessGate one(1234), other(1234);
  EXPECT_EQ(one.token().size(), 32U);
  EXPECT_NE(one.token(), other.token());
  EXPECT_TRUE(one.token_fits(one.token()));
  EXPECT_FALSE(one.token_fits(other.token()));
  EXPECT_FALSE(one.token_fits(""));
}

TEST(AccessTest, TheCookieIsFoundAmongOthersAndNoneThatOnlyContainsIt) {
  const AccessGate gate(1234, "secret");
  RequestOrigin request{"GET", "127.0.0.1:1234", "", "", "", ""};
  const auto status = [&](const std::string& cookie) {
    request.cookie = cookie;
    const auto refusal = gate.check(request);
    return refusal ? refusal->status : 200;
  };
  EXPECT_EQ(status("a=1; legwright_studio_1234=secret; b=2"), 200);
  EXPECT_EQ(status("legwright_studio_1234=secretly"), 401);
  EXPECT_EQ(status("xlegwright_studio_1234=secret"), 401);
  EXPECT_EQ(status("legwright_studio_999=secret"), 401) << "of a studio on another port";
  EXPECT_EQ(status(""), 401);
}

TEST(AccessTest, BodiesOfPostsAreJsonWithOrWithoutACharset) {
  const AccessGate gate(1234, "secret");
  RequestOrigin request{"POST", "127.0.0.1:1234", "", "", "legwright_studio_1234=secret", ""};
  for (const char* type : {"application/json", "application/json; charset=utf-8"}) {
    request.content_type = type;
    EXPECT_FALSE(gate.check(request)) << type;
  }
  for (const char* type : {"", "text/plain", "application/jsonp", "multipart/form-data"}) {
    request.content_type = type;
    ASSERT_TRUE(gate.check(request)) << type;
    EXPECT_EQ(gate.check(request)->status, 415);
  }
}

}  // namespace
}  // namespace legwright
