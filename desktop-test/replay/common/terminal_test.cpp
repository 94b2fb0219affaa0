#include "replay/common/terminal.h"

#include <gtest/gtest.h>

#include <cstdlib>
#include <fcntl.h>
#include <unistd.h>

namespace glide::replay {
namespace {

/// The three variables as a test wants them; back as they were afterwards.
class Environment {
 public:
  Environment(const char* term, const char* no_color, const char* force)
      : term_("TERM", term), no_color_("NO_COLOR", no_color), force_("CLICOLOR_FORCE", force) {}

 private:
  class Variable {
   public:
    Variable(const char* name, const char* value) : name_(name) {
      const char* before = std::getenv(name);
      had_ = before != nullptr;
      if (had_) before_ = before;
      if (value != nullptr) {
        setenv(name, value, 1);
      } else {
        unsetenv(name);
      }
    }
    ~Variable() {
      if (had_) {
        setenv(name_, before_.c_str(), 1);
      } else {
        unsetenv(name_);
      }
    }

   private:
    const char* name_;
    bool had_ = false;
    std::string before_;
  };
  const Variable term_, no_color_, force_;
};

/// The slave of a new pseudo terminal.
class PseudoTerminal {
 public:
  PseudoTerminal() : master_(posix_openpt(O_RDWR | O_NOCTTY)) {
    EXPECT_EQ(grantpt(master_), 0);
    EXPECT_EQ(unlockpt(master_), 0);
    slave_ = open(ptsname(master_), O_RDWR | O_NOCTTY);
    EXPECT_GE(slave_, 0);
  }
  ~PseudoTerminal() {
    close(slave_);
    close(master_);
  }
  int slave() const { return slave_; }

 private:
  int master_ = -1, slave_ = -1;
};

TEST(Terminal, IsRedrawnAndColoredWhenItIsOne) {
  const PseudoTerminal pty;
  const Environment environment("xterm", nullptr, nullptr);
  EXPECT_TRUE(terminalOf(pty.slave()).can_redraw);
  EXPECT_TRUE(terminalOf(pty.slave()).has_color);
}

TEST(Terminal, HasNoColorWithNoColor) {
  const PseudoTerminal pty;
  const Environment environment("xterm", "1", "1");
  EXPECT_TRUE(terminalOf(pty.slave()).can_redraw);
  EXPECT_FALSE(terminalOf(pty.slave()).has_color);
}

TEST(Terminal, IgnoresAnEmptyNoColor) {
  const PseudoTerminal pty;
  const Environment environment("xterm", "", nullptr);
  EXPECT_TRUE(terminalOf(pty.slave()).has_color);
}

TEST(Terminal, IsLeftAloneWhenItIsDumb) {
  const PseudoTerminal pty;
  const Environment environment("dumb", nullptr, nullptr);
  EXPECT_FALSE(terminalOf(pty.slave()).can_redraw);
  EXPECT_FALSE(terminalOf(pty.slave()).has_color);
}

TEST(Terminal, IsNoFileButAFileCanBeForcedToHaveColors) {
  const int file = open("/dev/null", O_WRONLY);
  {
    const Environment environment("xterm", nullptr, nullptr);
    EXPECT_FALSE(terminalOf(file).can_redraw);
    EXPECT_FALSE(terminalOf(file).has_color);
  }
  const Environment environment("xterm", nullptr, "1");
  EXPECT_FALSE(terminalOf(file).can_redraw);
  EXPECT_TRUE(terminalOf(file).has_color);
  close(file);
}

TEST(InkedText, CountsWhatIsSeen) {
  InkedText colored(true);
  colored.add("tracking ", Ink::plain).add("direct", Ink::direct);
  EXPECT_EQ(colored.text(), "tracking \x1b[38;5;208mdirect\x1b[0m");
  EXPECT_EQ(colored.width(), 15U);
  InkedText plain(false);
  plain.add("tracking ", Ink::plain).add("direct", Ink::direct);
  EXPECT_EQ(plain.text(), "tracking direct");
}

}  // namespace
}  // namespace glide::replay
