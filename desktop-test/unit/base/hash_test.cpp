#include "base/hash.h"

#include <gtest/gtest.h>

namespace glide {
namespace {

TEST(Fnv1a, GivesThePublishedValues) {
  EXPECT_EQ(fnv1a(bytesOf(""), kHashStart), 0xcbf29ce484222325U);
  EXPECT_EQ(fnv1a(bytesOf("a"), kHashStart), 0xaf63dc4c8601ec8cU);
  EXPECT_EQ(fnv1a(bytesOf("foobar"), kHashStart), 0x85944171f73967e8U);
}

TEST(Fnv1a, GoesOnWhereAnotherPartEnded) {
  EXPECT_EQ(fnv1a(bytesOf("bar"), fnv1a(bytesOf("foo"), kHashStart)), 0x85944171f73967e8U);
}

}  // namespace
}  // namespace glide
