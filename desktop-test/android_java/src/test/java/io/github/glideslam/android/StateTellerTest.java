package io.github.glideslam.android;

import static org.junit.Assert.assertEquals;
import static org.junit.Assert.assertThrows;

import io.github.glideslam.android.Camera2Source.State;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import org.junit.Test;

public final class StateTellerTest {
  private final List<State> told = new ArrayList<>();

  @Test
  public void tellsWhatWasAddedInThisOrder() {
    StateTeller teller = new StateTeller((state, reason) -> told.add(state));
    teller.add(State.OPENING, "");
    teller.add(State.STOPPED, "");
    teller.tell();
    teller.tell();
    assertEquals(Arrays.asList(State.OPENING, State.STOPPED), told);
  }

  @Test
  public void afterAListenerThatThrewTheRestIsTold() {
    StateTeller teller = new StateTeller((state, reason) -> {
      told.add(state);
      if (state == State.OPENING) {
        throw new IllegalStateException();
      }
    });
    teller.add(State.OPENING, "");
    teller.add(State.STOPPED, "");
    assertThrows(IllegalStateException.class, teller::tell);
    teller.tell();
    assertEquals(Arrays.asList(State.OPENING, State.STOPPED), told);
  }

  @Test
  public void withoutAListenerNothingIsTold() {
    StateTeller teller = new StateTeller(null);
    teller.add(State.OPENING, "");
    teller.tell();
  }
}
