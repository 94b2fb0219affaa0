package io.github.glideslam.android;

import android.content.Context;
import android.hardware.camera2.CameraAccessException;
import android.hardware.camera2.CameraCaptureSession;
import android.hardware.camera2.CameraCharacteristics;
import android.hardware.camera2.CameraManager;
import android.hardware.camera2.CameraMetadata;
import android.hardware.camera2.CaptureRequest;
import android.hardware.camera2.CaptureResult;
import android.hardware.camera2.TotalCaptureResult;
import android.os.Handler;
import android.os.HandlerThread;
import android.os.SystemClock;
import android.util.Size;
import android.view.Surface;
import io.github.glideslam.CameraInput;
import io.github.glideslam.UnsupportedConfigurationException;

/**
 * The camera on the device's back, set up for tracking: made for motion tracking where the device
 * can, stabilisation off, focus and frame rate fixed. Its images go to a surface: {@link
 * TextureFrames} or {@link LumaFrames} have one. The app asks for the CAMERA permission before it
 * makes one of these: without, Android hides the calibration.
 *
 * <p>{@link #start} and {@link #stop} belong into onResume and onPause. Any thread.
 */
public final class Camera2Source implements AutoCloseable {
  private static final int FRAMES_PER_SECOND = 30;

  /** Where it stands. */
  public enum State {
    /** Not started, or stopped. */
    STOPPED,
    /** Waiting for the camera to open. */
    OPENING,
    /** Open; waiting for it to take the surface. */
    CONFIGURING,
    /** Images are on their way. */
    RUNNING,
    /** The camera is gone, and given back; {@link #start} tries again. */
    FAILED,
    /** Closed for good. */
    CLOSED
  }

  /**
   * Told each new state, one after the other in the order in which they came: on the thread that
   * brought it about, the camera's or the caller's, or, while another thread is telling, on that one.
   */
  public interface Listener {
    /** {@code reason} is empty unless the state is FAILED. */
    void onStateChanged(State state, String reason);
  }

  private final CameraManager manager;
  private final String cameraId;
  private final CameraReport report;
  private final Size size;
  private final CameraCalibration calibration;
  private final CaptureSettings settings;
  private final StateTeller teller;
  private final FrameTimings timings = new FrameTimings();
  private final HandlerThread thread = new HandlerThread("glide-camera");
  private final Handler handler;
  private CameraClock clock;
  private CameraRun run;
  private State state = State.STOPPED;
  // Until all have come, the thread that they come on has to live.
  private int awaitedAnswers;

  /**
   * Images of the offered size nearest to {@code wanted}. UnsupportedConfigurationException when there
   * is no such camera.
   */
  public Camera2Source(Context context, Size wanted, Listener listener) {
    teller = new StateTeller(listener);
    manager = (CameraManager) context.getSystemService(Context.CAMERA_SERVICE);
    try {
      cameraId = CameraReport.backCamera(manager);
      report = new CameraReport(manager.getCameraCharacteristics(cameraId));
    } catch (CameraAccessException e) {
      throw new UnsupportedConfigurationException("the cameras cannot be listed: " + e.getMessage());
    }
    size = report.streamSize(wanted);
    calibration = CameraIntrinsicsConverter.convert(report.facts(size));
    settings = new CaptureSettings(report, FRAMES_PER_SECOND);
    clock = newClock();
    thread.start();
    handler = new Handler(thread.getLooper());
  }

  /** Of the images. */
  public Size getSize() {
    return size;
  }

  /** Of the images, unturned. */
  public CameraCalibration getCalibration() {
    return calibration;
  }

  /** SENSOR_ORIENTATION, degrees: for {@link DisplayTransform#imageRotation}. */
  public int getSensorOrientation() {
    return report.get(CameraCharacteristics.SENSOR_ORIENTATION, 0);
  }

  /** Whether the camera's times are exact in the clock of SensorEvent; else about right. */
  public boolean isClockShared() {
    return report.get(CameraCharacteristics.SENSOR_INFO_TIMESTAMP_SOURCE,
            CameraMetadata.SENSOR_INFO_TIMESTAMP_SOURCE_UNKNOWN)
        == CameraMetadata.SENSOR_INFO_TIMESTAMP_SOURCE_REALTIME;
  }

  /** Whether images are stabilised by moving the lens, which cannot be turned off: expect drift. */
  public boolean isLensMoving() {
    int[] modes = report.get(
        CameraCharacteristics.LENS_INFO_AVAILABLE_OPTICAL_STABILIZATION, new int[0]);
    return modes.length > 0
        && !report.has(CameraCharacteristics.LENS_INFO_AVAILABLE_OPTICAL_STABILIZATION,
            CameraMetadata.LENS_OPTICAL_STABILIZATION_MODE_OFF);
  }

  /** Where it stands. */
  public synchronized State getState() {
    return state;
  }

  /** Opens the camera; returns at once. Started already: begins anew, with this surface. */
  public void start(Surface surface) {
    CameraRun started;
    synchronized (this) {
      if (state == State.CLOSED) {
        throw new IllegalStateException("the camera source is closed");
      }
      closeRun();
      clock = newClock();
      run = new CameraRun(new Progress(), surface, settings, new Results());
      started = run;
      enter(State.OPENING, "");
      ++awaitedAnswers;
    }
    teller.tell();
    handler.post(() -> started.open(manager, cameraId, handler));
  }

  /** Gives the camera back before it returns. More than once is fine. */
  public void stop() {
    synchronized (this) {
      if (state == State.STOPPED || state == State.CLOSED) {
        return;
      }
      closeRun();
      enter(State.STOPPED, "");
    }
    teller.tell();
  }

  /** Stops for good. More than once is fine. */
  @Override
  public void close() {
    stop();
    synchronized (this) {
      if (state == State.CLOSED) {
        return;
      }
      enter(State.CLOSED, "");
      quitWhenAnswered();
    }
    teller.tell();
  }

  /**
   * Gives a frame its time, exposure and rolling shutter. {@code sensorNs} is that of
   * SurfaceTexture.getTimestamp or Image.getTimestamp; the frame's time is the middle of its exposure.
   */
  void stamp(CameraInput input, long sensorNs, FrameTimings.Timing timing) {
    timings.find(sensorNs, timing);
    synchronized (this) {
      input.setTimestamp(clock.frameTime(sensorNs, timing.exposureNs, timing.skewNs));
    }
    input.setExposure(timing.exposureNs);
    input.setRollingShutterSkew(timing.skewNs);
  }

  private CameraClock newClock() {
    return isClockShared()
        ? CameraClock.realtime()
        : CameraClock.uptime(SystemClock.elapsedRealtimeNanos(), System.nanoTime());
  }

  private void closeRun() {
    if (run != null) {
      run.close();
      run = null;
    }
  }

  private void quitWhenAnswered() {
    if (state == State.CLOSED && awaitedAnswers == 0) {
      thread.quitSafely();
    }
  }

  /** With the lock held, so that states are told as they came; teller.tell() follows without it. */
  private void enter(State newState, String reason) {
    state = newState;
    teller.add(newState, reason);
  }

  /** What a run that is still wanted reaches. */
  private final class Progress implements CameraRun.Owner {
    @Override
    public void onAnswered() {
      synchronized (Camera2Source.this) {
        --awaitedAnswers;
        quitWhenAnswered();
      }
    }

    @Override
    public void onConfiguring(CameraRun from) {
      reach(from, State.CONFIGURING, "");
    }

    @Override
    public void onRunning(CameraRun from) {
      reach(from, State.RUNNING, "");
    }

    @Override
    public void onFailed(CameraRun from, String reason) {
      reach(from, State.FAILED, reason);
    }

    private void reach(CameraRun from, State reached, String reason) {
      synchronized (Camera2Source.this) {
        if (from != run) {
          return;
        }
        enter(reached, reason);
      }
      teller.tell();
    }
  }

  private final class Results extends CameraCaptureSession.CaptureCallback {
    @Override
    public void onCaptureCompleted(
        CameraCaptureSession session, CaptureRequest request, TotalCaptureResult result) {
      Long sensorNs = result.get(CaptureResult.SENSOR_TIMESTAMP);
      if (sensorNs != null) {
        timings.add(
            sensorNs,
            orZero(result.get(CaptureResult.SENSOR_EXPOSURE_TIME)),
            orZero(result.get(CaptureResult.SENSOR_ROLLING_SHUTTER_SKEW)));
      }
    }

    private long orZero(Long value) {
      return value == null ? 0 : value;
    }
  }
}
