#include "input/svg/svg.hpp"
#include <gtest/gtest.h>
TEST(Svg, X){ EXPECT_TRUE(strandline::svg::read("<svg/>")); }
