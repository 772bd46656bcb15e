#!/usr/bin/env bash
# Takes the README's pictures of the real window anew, into assets/screenshots.
# Builds the release binary first; what else it needs is in support/display.sh.
set -euo pipefail
cd "$(dirname "$0")/.."
. tests/support/display.sh
cargo build --locked --release
out=$PWD/assets/screenshots
mkdir -p "$out"
start_display 1280x800
export DISPLAY=$display

# shot NAME SCENE|--lesson=N SETTINGS [SECONDS [ACTION]]: the window without its frame, on the whole
# screen, after an action of the mouse.
shot() {
  open_window target/release/pinhole "$3" "$2"
  if [ $# -ge 5 ]; then sleep 2; "$5"; fi
  xdotool mousemove 1279 799
  sleep "${4:-2}"
  import -window "$window" "$out/$1.png"
  close_window
}

# Grades a picture of the scene in which the viewport's distance was taken as 1.
check_answers() {
  sed 's/^distance = .*/distance = 1.0/' assets/scenes/distance-two.toml >"$work/one.toml"
  target/release/pinhole render "$work/one.toml" -o "$work/answers.png"
  xdotool key ctrl+p; sleep 1; xdotool type 'Check answers'; sleep 1; xdotool key Return; sleep 1
  xdotool type "$work/answers.png"; sleep 1; xdotool key Return
}

shot canonical canonical '{}'
shot look-at-light look-at '{"theme": "Light"}'
shot planet planet '{}'
shot translator look-at '{"layout": "Translator"}'
# Measuring takes its time.
shot accuracy planet '{"layout": "Accuracy"}' 20
shot answers distance-two '{}' 2 check_answers
shot lesson-7 --lesson=7.3 '{}'
shot lesson-11 --lesson=11.3 '{}'
shot lesson-12 --lesson=12.2 '{}'
