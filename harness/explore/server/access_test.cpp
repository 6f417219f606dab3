#include "harness/explore/server/access.h"

#include <gtest/gtest.h>

namespace mwt {
namespace {

TEST(Access, IsGrantedToItsOwnPagesOnly) {
  const Access access("0123abcd", 8080);
  using Head = RequestHead;
  EXPECT_EQ(access.granted(Head{"127.0.0.1:8080", {}, "/0123abcd/"}), "");
  EXPECT_EQ(access.granted(Head{"localhost:8080", "http://localhost:8080", "/0123abcd/job"}), "job");
  for (const Head& head :
       {Head{"", {}, "/0123abcd/"}, Head{"127.0.0.1", {}, "/0123abcd/"}, Head{"127.0.0.1:80801", {}, "/0123abcd/"},
        Head{"127.0.0.1.evil:8080", {}, "/0123abcd/"}, Head{"127.0.0.1:8080", "", "/0123abcd/"},
        Head{"127.0.0.1:8080", "null", "/0123abcd/"}, Head{"127.0.0.1:8080", "http://evil:8080", "/0123abcd/"},
        Head{"127.0.0.1:8080", "http://127.0.0.1:8081", "/0123abcd/"}, Head{"127.0.0.1:8080", {}, ""},
        Head{"127.0.0.1:8080", {}, "/"}, Head{"127.0.0.1:8080", {}, "/0123abcd"},
        Head{"127.0.0.1:8080", {}, "/0123abce/"}, Head{"127.0.0.1:8080", {}, "/0123abcdx/"},
        Head{"127.0.0.1:8080", {}, "//0123abcd/"}}) {
    EXPECT_FALSE(access.granted(head)) << head.host << " " << head.origin.value_or("-") << " " << head.path;
  }
}

TEST(Access, TokensAreRandom) {
  EXPECT_EQ(random_token().size(), 32U);
  EXPECT_NE(random_token(), random_token());
}

}  // namespace
}  // namespace mwt
