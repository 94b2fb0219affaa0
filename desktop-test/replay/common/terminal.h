#pragma once

#include <cstddef>
#include <string>
#include <string_view>

namespace glide::replay {

/// What a program's output may look like where it goes.
struct Terminal {
  bool can_redraw = false;  ///< a terminal that can go back to the start of a line and erase it
  bool has_color = false;
};

/// How text is to look; the trackers' colours are those of the renderers and the report, the blue
/// lighter, for a dark background.
enum class Ink { plain, strong, direct, indirect, alarm };

/// Of an open file descriptor. Colours follow NO_COLOR (https://no-color.org) first, then
/// CLICOLOR_FORCE; else a terminal has them unless TERM is dumb or missing.
Terminal terminalOf(int descriptor);

/// The terminal's present width in characters; 80 when it tells none.
int columnsOf(int descriptor);

/// Text for a terminal that knows how wide it is: escape codes take no room.
class InkedText {
 public:
  explicit InkedText(bool has_color) : has_color_(has_color) {}

  InkedText& add(std::string_view text, Ink ink);
  const std::string& text() const { return text_; }
  std::size_t width() const { return width_; }

 private:
  const bool has_color_;
  std::string text_;
  std::size_t width_ = 0;  ///< characters; ASCII only
};

}  // namespace glide::replay
