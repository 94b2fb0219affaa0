package io.github.glideslam.android;

import android.graphics.Rect;
import android.hardware.camera2.CameraCharacteristics;
import android.hardware.camera2.CameraCharacteristics.Key;
import android.hardware.camera2.CameraMetadata;
import android.hardware.camera2.params.StreamConfigurationMap;
import android.util.Range;
import android.util.Size;
import android.util.SizeF;
import org.robolectric.shadow.api.Shadow;
import org.robolectric.shadows.ShadowCameraCharacteristics;
import org.robolectric.shadows.StreamConfigurationMapBuilder;

/** What a phone of 2020 tells about the camera on its back. */
public final class PhoneCamera {
  private final CameraCharacteristics told =
      ShadowCameraCharacteristics.newCameraCharacteristics();

  @SuppressWarnings("rawtypes") // arrays of generics
  public PhoneCamera() {
    StreamConfigurationMap streams = StreamConfigurationMapBuilder.newBuilder()
        .addOutputSize(new Size(1920, 1080))
        .addOutputSize(new Size(640, 480))
        .build();
    with(CameraCharacteristics.LENS_FACING, CameraMetadata.LENS_FACING_BACK);
    with(CameraCharacteristics.SENSOR_ORIENTATION, 90);
    with(CameraCharacteristics.SCALER_STREAM_CONFIGURATION_MAP, streams);
    with(CameraCharacteristics.SENSOR_INFO_ACTIVE_ARRAY_SIZE, new Rect(0, 0, 4000, 3000));
    with(CameraCharacteristics.SENSOR_INFO_PIXEL_ARRAY_SIZE, new Size(4000, 3000));
    with(CameraCharacteristics.SENSOR_INFO_PHYSICAL_SIZE, new SizeF(5, 3.75f));
    with(CameraCharacteristics.SENSOR_INFO_TIMESTAMP_SOURCE,
        CameraMetadata.SENSOR_INFO_TIMESTAMP_SOURCE_REALTIME);
    with(CameraCharacteristics.LENS_INFO_AVAILABLE_FOCAL_LENGTHS, new float[] {4});
    with(CameraCharacteristics.LENS_INFO_MINIMUM_FOCUS_DISTANCE, 10f);
    with(CameraCharacteristics.LENS_INFO_HYPERFOCAL_DISTANCE, 0.25f);
    with(CameraCharacteristics.LENS_INFO_AVAILABLE_OPTICAL_STABILIZATION, new int[] {0, 1});
    with(CameraCharacteristics.CONTROL_AF_AVAILABLE_MODES, new int[] {0, 1, 3, 4});
    with(CameraCharacteristics.CONTROL_AE_AVAILABLE_TARGET_FPS_RANGES,
        new Range[] {new Range<>(15, 30), new Range<>(30, 30), new Range<>(60, 60)});
  }

  /** Sets what is told under a key; once. */
  public PhoneCamera with(Key<?> key, Object value) {
    ShadowCameraCharacteristics shadow = Shadow.extract(told);
    shadow.set(key, value);
    return this;
  }

  public PhoneCamera calibrated() {
    return with(
        CameraCharacteristics.LENS_INTRINSIC_CALIBRATION, new float[] {3200, 3200, 2000, 1500, 0});
  }

  public CameraCharacteristics characteristics() {
    return told;
  }
}
