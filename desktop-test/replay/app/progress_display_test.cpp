#include "replay/app/progress_display.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace glide::replay {
namespace {

using ::testing::HasSubstr;
using ::testing::Not;
using ::testing::StartsWith;

ProgressView halfWay() {
  ProgressView view;
  view.done = 50;
  view.total = 100;
  view.direct = 40;
  view.tracked = 45;
  view.elapsed_s = 2.0;
  view.state = TrackingState::tracking;
  view.tracker = TrackerKind::direct;
  view.map = {12, 3456, 0};
  return view;
}

TEST(Progress, ShowsABarOnlyWhenTheEndIsKnown) {
  ProgressView view = halfWay();
  const std::string bar = progressBar(view, {160, false});
  EXPECT_THAT(bar,
              StartsWith("[===============>              ] 50/100   25.0 fps  tracking direct"));
  EXPECT_THAT(bar, HasSubstr("12 keyframes  3456 landmarks  direct 89 %"));
  view.total = 0;
  EXPECT_THAT(progressBar(view, {160, false}), StartsWith("50   25.0 fps"));
}

TEST(Progress, SaysLessWhereThereIsLessRoomAndNeverFillsTheLine) {
  const ProgressView view = halfWay();
  for (int columns = 1; columns < 160; ++columns)
    EXPECT_LT(static_cast<int>(progressBar(view, {columns, false}).size()), columns);
  EXPECT_THAT(progressBar(view, {72, false}), HasSubstr("12 kf  3456 lm"));
  EXPECT_THAT(progressBar(view, {55, false}), HasSubstr("tracking direct"));
  EXPECT_THAT(progressBar(view, {20, false}), HasSubstr("50/100"));
}

TEST(Progress, PaintsTheTrackerAndTheLoss) {
  ProgressView view = halfWay();
  EXPECT_THAT(progressLine(view, true), HasSubstr("tracking \x1b[38;5;208mdirect\x1b[0m"));
  view.tracker = TrackerKind::indirect;
  EXPECT_THAT(progressLine(view, true), HasSubstr("tracking \x1b[38;5;33mindirect\x1b[0m"));
  view.state = TrackingState::lost;
  EXPECT_THAT(progressLine(view, true), HasSubstr("\x1b[1;31mlost\x1b[0m"));
  EXPECT_THAT(progressLine(view, false), Not(HasSubstr("\x1b")));
}

}  // namespace
}  // namespace glide::replay
