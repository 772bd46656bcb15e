# To be sourced: a display of its own for pictures of the real window.
# Needs Xvfb, openbox, xdotool and ImageMagick.

# start_display WIDTHxHEIGHT: sets `display`, the name of a new X server with a window manager, and
# `work`, a folder for files of no use later, in which the program also keeps its state. Both are
# gone when the script ends.
start_display() {
  local pipe number
  display_width=${1%x*}
  work=$(mktemp -d)
  exec {pipe}<> <(:)
  Xvfb -displayfd "$pipe" -screen 0 "${1}x24" -nolisten tcp -noreset 2>/dev/null &
  server=$!
  trap 'kill "$server" 2>/dev/null; rm -rf "$work"' EXIT
  read -r number <&"$pipe"
  display=:$number
  export WINIT_X11_SCALE_FACTOR=1 XDG_STATE_HOME=$work
  unset WAYLAND_DISPLAY DISPLAY
  DISPLAY=$display openbox 2>/dev/null &
  until DISPLAY=$display xdotool get_num_desktops >/dev/null 2>&1; do sleep 0.1; done
}

# Waits a little; after a minute of that, gives up for the reason.
wait_once() {
  sleep 0.1
  if ((++tries > 600)); then
    echo "$1" >&2
    exit 1
  fi
}

# open_window PROGRAM SETTINGS ARGUMENT...: the program's window on all of the display; sets `process`
# and `window`.
open_window() {
  local program=$1 settings=$2
  shift 2
  mkdir -p "$work/pinhole"
  printf '{"settings": %s, "window": {"maximized": true}}' "$settings" >"$work/pinhole/state.json"
  DISPLAY=$display "$program" "$@" 2>/dev/null &
  process=$!
  local tries=0
  until window=$(DISPLAY=$display xdotool search --onlyvisible --name ' - Pinhole'); do
    wait_once 'no window appears'
  done
  # It is maximised a little later; the borders may stay.
  local WIDTH=0
  until ((WIDTH > display_width - 10)); do
    wait_once 'the window is not maximised: are the settings as the program writes them?'
    eval "$(DISPLAY=$display xdotool getwindowgeometry --shell "$window" | grep WIDTH)"
  done
}

# Ends the program that `open_window` began.
close_window() {
  kill "$process"
  wait "$process" 2>/dev/null || true
}
