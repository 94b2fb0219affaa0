#include "replay/common/terminal.h"

#include <cstdlib>
#include <sys/ioctl.h>
#include <unistd.h>

namespace glide::replay {
namespace {

constexpr int kUsualColumns = 80;

std::string_view variable(const char* name) {
  const char* value = std::getenv(name);
  return value == nullptr ? "" : value;
}

/// SGR codes (ECMA-48); 38;5;N are xterm's 256 colours.
std::string_view codeOf(Ink ink) {
  switch (ink) {
    case Ink::plain:
      break;
    case Ink::strong:
      return "1";
    case Ink::direct:
      return "38;5;208";
    case Ink::indirect:
      return "38;5;33";
    case Ink::alarm:
      return "1;31";
  }
  return "";
}

}  // namespace

Terminal terminalOf(int descriptor) {
  const std::string_view kind = variable("TERM");
  Terminal terminal;
  terminal.can_redraw = isatty(descriptor) != 0 && !kind.empty() && kind != "dumb";
  const std::string_view force = variable("CLICOLOR_FORCE");
  const bool is_forced = !force.empty() && force != "0";
  terminal.has_color = variable("NO_COLOR").empty() && (is_forced || terminal.can_redraw);
  return terminal;
}

int columnsOf(int descriptor) {
  winsize size{};
  if (ioctl(descriptor, TIOCGWINSZ, &size) != 0 || size.ws_col == 0) return kUsualColumns;
  return size.ws_col;
}

InkedText& InkedText::add(std::string_view text, Ink ink) {
  const std::string_view code = has_color_ ? codeOf(ink) : "";
  if (!code.empty()) text_.append("\x1b[").append(code).append("m");
  text_ += text;
  if (!code.empty()) text_ += "\x1b[0m";
  width_ += text.size();
  return *this;
}

}  // namespace glide::replay
