package io.github.glideslam;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import org.junit.jupiter.api.DisplayName;
import org.junit.jupiter.api.Test;

class LayoutTest {
  @Test
  @DisplayName("Java's offsets are those of the library's structs")
  void offsets() {
    assertArrayEquals(Native.layout(), Layout.expected());
  }

  @Test
  @DisplayName("a struct is zeroed, direct, and knows its size")
  void structs() {
    assertTrue(Layout.struct(Layout.FRAME_SIZE).isDirect());
    assertEquals(Layout.FRAME_SIZE, Layout.struct(Layout.FRAME_SIZE).getInt(0));
    assertEquals(0, Layout.struct(Layout.FRAME_SIZE).getLong(Layout.FRAME_TIME));
  }

  @Test
  @DisplayName("the library tells its version")
  void version() {
    assertTrue(Session.getLibraryVersion().matches("\\d+\\.\\d+\\.\\d+"));
  }
}
