package io.github.glideslam;

import static org.junit.jupiter.api.Assertions.assertInstanceOf;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.lang.reflect.InvocationTargetException;
import java.net.URL;
import java.net.URLClassLoader;
import org.junit.jupiter.api.Assertions;
import org.junit.jupiter.api.DisplayName;
import org.junit.jupiter.api.Test;

class LibraryTest {
  @Test
  @DisplayName("without the native library every attempt says which one, and where it was looked for")
  void missing() throws Exception {
    Session.getLibraryVersion(); // a library that one class loader has is refused to every other
    URL classes = Session.class.getProtectionDomain().getCodeSource().getLocation();
    try (URLClassLoader other =
        new URLClassLoader(new URL[] {classes}, ClassLoader.getPlatformClassLoader())) {
      Class<?> session = other.loadClass(Session.class.getName());
      for (int attempt = 0; attempt < 2; ++attempt) {
        Throwable e = Assertions.assertThrows(
            InvocationTargetException.class,
            () -> session.getMethod("getLibraryVersion").invoke(null)).getCause();
        assertInstanceOf(UnsatisfiedLinkError.class, e);
        String message = e.getMessage();
        assertTrue(message.contains(System.mapLibraryName("glide_jni")), message);
        assertTrue(message.contains("already loaded in another"), message);
        assertTrue(message.contains(System.getProperty("java.library.path")), message);
      }
    }
  }
}
