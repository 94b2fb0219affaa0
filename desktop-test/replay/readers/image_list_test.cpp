#include "replay/readers/image_list.h"

#include "replay/readers/open_source.h"
#include "replay/readers/scratch_folder.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace glide::replay {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;

std::vector<std::string> namesOf(FrameSource& source) {
  std::vector<std::string> names;
  while (const auto frame = source.next()) names.push_back(frame->name);
  return names;
}

std::vector<std::string> skipsOf(const FrameSource& source) {
  std::vector<std::string> lines;
  for (const Skip& skip : source.skips().skips()) {
    lines.push_back(describe(skip, source.info().listed));
  }
  return lines;
}

/// Ten entries a second, named by their index.
std::vector<ImageEntry> tenHertz(int count) {
  std::vector<ImageEntry> images;
  for (int i = 0; i < count; ++i) images.push_back({i * 100'000'000LL, "", std::to_string(i)});
  return images;
}

std::vector<std::string> selectedNames(const FrameSelection& selection) {
  std::vector<std::string> names;
  for (const ImageEntry& image : selectEntries(tenHertz(10), selection)) {
    names.push_back(image.name);
  }
  return names;
}

TEST(FrameSelection, CutsByTimeThenStrideThenCount) {
  FrameSelection selection;
  EXPECT_EQ(selectedNames(selection).size(), 10u);
  selection.start_s = 0.2;
  selection.duration_s = 0.5;
  EXPECT_THAT(selectedNames(selection), ElementsAre("2", "3", "4", "5", "6"));
  selection.stride = 2;
  EXPECT_THAT(selectedNames(selection), ElementsAre("2", "4", "6"));
  selection.max_frames = 2;
  EXPECT_THAT(selectedNames(selection), ElementsAre("2", "4"));
}

TEST(ImageList, SkipsNamesAndCountsWhatCannotBeUsed) {
  const ScratchFolder folder;
  folder.writeImage("a.png", CV_8UC1, 32, 24);
  folder.writeImage("b.png", CV_16UC1, 32, 24);
  folder.writeImage("c.png", CV_8UC1, 24, 32);
  folder.write("d.png", "");
  folder.write("e.png", "");
  folder.writeImage("g.png", CV_8UC3, 32, 24);
  folder.write("rgb.txt",
               "1 a.png\n2 b.png\n3 c.png\n4 d.png\n5 e.png\n6 f.png\n7 g.png\n8 h.png\n");
  const auto opened = openSource(folder.path().string(), {}, std::nullopt);
  ASSERT_TRUE(opened.ok());
  EXPECT_THAT(namesOf(*opened->frames), ElementsAre("a.png", "g.png"));
  EXPECT_EQ(opened->frames->info().width, 32);
  EXPECT_EQ(opened->frames->info().height, 24);
  EXPECT_EQ(opened->frames->info().frames, 6);
  EXPECT_THAT(skipsOf(*opened->frames),
              ElementsAre("2 of 8 images listed in rgb.txt are missing (first: f.png)",
                          "1 of 8 images do not have 8 bits per channel (first: b.png)",
                          "1 of 8 images have another size than the first one (first: c.png)",
                          "2 of 8 images are empty files (first: d.png)"));
}

TEST(ImageList, SaysWhyThereIsNoImageAtAll) {
  const ScratchFolder folder;
  folder.write("rgb.txt", "1 a.png\n2 b.png\n");
  folder.writeImage("b.png", CV_16UC1, 8, 8);
  const auto opened = openSource(folder.path().string(), {}, std::nullopt);
  ASSERT_FALSE(opened.ok());
  EXPECT_THAT(opened.error().message, HasSubstr("no readable image"));
  EXPECT_THAT(opened.error().message, HasSubstr("1 of 2 images listed in rgb.txt are missing"));
  EXPECT_THAT(opened.error().message, HasSubstr("8 bits per channel (first: b.png)"));
}

TEST(ImageList, SaysWhenTheSelectionIsEmpty) {
  const ScratchFolder folder;
  folder.write("rgb.txt", "1 a.png\n");
  folder.writeImage("a.png", CV_8UC1, 8, 8);
  FrameSelection late;
  late.start_s = 100.0;
  const auto opened = openSource(folder.path().string(), late, std::nullopt);
  ASSERT_FALSE(opened.ok());
  EXPECT_THAT(opened.error().message, HasSubstr("--start"));
}

TEST(OpenSource, RecognisesEachLayout) {
  const ScratchFolder folder;
  folder.write("tum/rgb.txt", "1 a.png\n");
  folder.writeImage("tum/a.png", CV_8UC1, 8, 8);
  folder.write("euroc/mav0/cam0/data.csv", "1000,a.png\n");
  folder.writeImage("euroc/mav0/cam0/data/a.png", CV_8UC1, 8, 8);
  folder.writeImage("images/a.png", CV_8UC1, 8, 8);
  for (const char* kind : {"tum", "euroc", "images"}) {
    const auto opened = openSource((folder.path() / kind).string(), {}, std::nullopt);
    ASSERT_TRUE(opened.ok()) << kind;
    EXPECT_EQ(opened->frames->info().kind, kind);
    EXPECT_EQ(opened->frames->info().name, kind);
  }
}

TEST(OpenSource, ObeysAPrefix) {
  const ScratchFolder folder;
  folder.write("rgb.txt", "1 a.png\n");
  folder.writeImage("a.png", CV_8UC1, 8, 8);
  const auto opened = openSource("images:" + folder.path().string(), {}, std::nullopt);
  ASSERT_TRUE(opened.ok());
  EXPECT_EQ(opened->frames->info().kind, "images");
  EXPECT_FALSE(openSource("euroc:" + folder.path().string(), {}, std::nullopt).ok());
}

TEST(OpenSource, SaysWhatItExpectsInsteadOfAStrangePath) {
  const ScratchFolder folder;
  EXPECT_THAT(openSource("/no/such/place", {}, std::nullopt).error().message,
              HasSubstr("/no/such/place: does not exist"));
  EXPECT_THAT(openSource(folder.path().string(), {}, std::nullopt).error().message,
              HasSubstr("not recognised"));
  const auto text = folder.write("notes.txt", "hello");
  EXPECT_THAT(openSource(text.string(), {}, std::nullopt).error().message,
              HasSubstr("not recognised"));
}

}  // namespace
}  // namespace glide::replay
