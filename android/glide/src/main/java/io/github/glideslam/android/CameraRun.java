package io.github.glideslam.android;

import android.annotation.SuppressLint;
import android.hardware.camera2.CameraAccessException;
import android.hardware.camera2.CameraCaptureSession;
import android.hardware.camera2.CameraDevice;
import android.hardware.camera2.CameraManager;
import android.hardware.camera2.CaptureRequest;
import android.os.Handler;
import android.view.Surface;
import java.util.Collections;

/**
 * One opening of the camera, from open to close. Callbacks come on the handler's thread; after {@link
 * #close}, from any thread, nothing is told to the owner any more.
 */
final class CameraRun {
  /** Told on the handler's thread. */
  interface Owner {
    /** Once, always: the camera has opened, or will not. No device callback was lost. */
    void onAnswered();

    void onConfiguring(CameraRun run);

    void onRunning(CameraRun run);

    void onFailed(CameraRun run, String reason);
  }

  private final Owner owner;
  private final Surface surface;
  private final CaptureSettings settings;
  private final CameraCaptureSession.CaptureCallback results;
  private Handler handler;
  private CameraDevice device;
  private boolean closed;
  private boolean answered;

  CameraRun(
      Owner owner,
      Surface surface,
      CaptureSettings settings,
      CameraCaptureSession.CaptureCallback results) {
    this.owner = owner;
    this.surface = surface;
    this.settings = settings;
    this.results = results;
  }

  /** On the handler's thread. */
  @SuppressLint("MissingPermission") // what Android says about it becomes the reason
  void open(CameraManager manager, String cameraId, Handler callbackHandler) {
    handler = callbackHandler;
    if (isClosed()) {
      answer();
      return;
    }
    try {
      manager.openCamera(cameraId, new DeviceCallbacks(), handler);
    } catch (SecurityException e) {
      answer();
      fail("the app has no permission to use the camera");
    } catch (CameraAccessException | IllegalArgumentException e) {
      answer();
      fail("the camera does not open: " + e.getMessage());
    }
  }

  /** Gives the camera back; more than once is fine. The surface may be released then. */
  synchronized void close() {
    closed = true;
    if (device != null) {
      device.close(); // its session with it
      device = null;
    }
  }

  private void answer() {
    synchronized (this) {
      if (answered) {
        return;
      }
      answered = true;
    }
    owner.onAnswered();
  }

  private void fail(String reason) {
    boolean wasClosed;
    synchronized (this) {
      wasClosed = closed;
      close();
    }
    if (!wasClosed) {
      owner.onFailed(this, reason);
    }
  }

  private synchronized boolean isClosed() {
    return closed;
  }

  /** False, and the camera is given back, when nobody wants it any more. */
  private synchronized boolean take(CameraDevice opened) {
    if (closed) {
      opened.close();
      return false;
    }
    device = opened;
    return true;
  }

  // SessionConfiguration, which replaces this method, came with API 28.
  @SuppressWarnings("deprecation")
  private void configure(CameraDevice opened) {
    owner.onConfiguring(this);
    try {
      opened.createCaptureSession(
          Collections.singletonList(surface), new SessionCallbacks(), handler);
    } catch (CameraAccessException | IllegalArgumentException | IllegalStateException e) {
      fail("the camera does not take the surface: " + e.getMessage());
    }
  }

  private void repeat(CameraCaptureSession session) {
    try {
      CaptureRequest.Builder request =
          session.getDevice().createCaptureRequest(CameraDevice.TEMPLATE_PREVIEW);
      request.addTarget(surface);
      settings.applyTo(request);
      session.setRepeatingRequest(request.build(), results, handler);
    } catch (CameraAccessException | IllegalArgumentException | IllegalStateException e) {
      fail("the camera does not start: " + e.getMessage());
      return;
    }
    if (!isClosed()) {
      owner.onRunning(this);
    }
  }

  private final class DeviceCallbacks extends CameraDevice.StateCallback {
    @Override
    public void onOpened(CameraDevice opened) {
      answer();
      if (take(opened)) {
        configure(opened);
      }
    }

    @Override
    public void onDisconnected(CameraDevice gone) {
      answer();
      take(gone);
      fail("the camera was taken by another app");
    }

    @Override
    public void onError(CameraDevice broken, int error) {
      answer();
      take(broken);
      fail("the camera reports error " + error);
    }
  }

  private final class SessionCallbacks extends CameraCaptureSession.StateCallback {
    @Override
    public void onConfigured(CameraCaptureSession session) {
      if (!isClosed()) {
        repeat(session);
      }
    }

    @Override
    public void onConfigureFailed(CameraCaptureSession session) {
      fail("the camera does not take a surface of this size");
    }
  }
}
