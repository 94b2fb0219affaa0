package io.github.glideslam.sample;

import android.content.Context;
import android.graphics.Color;
import android.view.Gravity;
import android.view.View;
import android.widget.Button;
import android.widget.FrameLayout;
import android.widget.LinearLayout;
import android.widget.TextView;

/** A line of text and buttons over another view. Main thread. */
final class Controls {
  private static final int BACKGROUND = Color.argb(128, 0, 0, 0);

  private final FrameLayout root;
  private final TextView text;
  private final LinearLayout buttons;

  Controls(Context context, View below) {
    root = new FrameLayout(context);
    text = new TextView(context);
    text.setTextColor(Color.WHITE);
    text.setBackgroundColor(BACKGROUND);
    buttons = new LinearLayout(context);
    buttons.setGravity(Gravity.CENTER);
    LinearLayout column = new LinearLayout(context);
    column.setOrientation(LinearLayout.VERTICAL);
    column.setFitsSystemWindows(true); // clear of the bars
    column.addView(text);
    column.addView(buttons);
    root.addView(below);
    root.addView(column, new FrameLayout.LayoutParams(
        FrameLayout.LayoutParams.MATCH_PARENT, FrameLayout.LayoutParams.WRAP_CONTENT,
        Gravity.BOTTOM));
  }

  View getRoot() {
    return root;
  }

  void addButton(String label, Runnable action) {
    Button button = new Button(root.getContext());
    button.setText(label);
    button.setOnClickListener(view -> action.run());
    buttons.addView(button);
  }

  void setText(String value) {
    text.setText(value);
  }
}
