"use strict";

// What the program asks of the page: src/platform/web/page.rs says what each function does.
var pinhole = (() => {
  // The page as it was written, before anything changes it.
  const source = "<!doctype html>\n" + document.documentElement.outerHTML + "\n";
  const element = (id) => document.getElementById(id);
  const PREFIX = "pinhole:";

  const storage = () => {
    try { return window.localStorage; } catch { return null; }
  };

  function store(key, text) {
    try {
      const kept = storage();
      if (!kept) return "this browser does not let the page store anything";
      kept.setItem(PREFIX + key, text);
    } catch (error) {
      return error.name === "QuotaExceededError"
        ? "the storage that this browser gives the page is full"
        : "this browser does not let the page store anything";
    }
  }

  // The locks that other pages hold, and the functions that release this page's own.
  const taken = new Set();
  const releases = new Map();

  // Finds the locks of other pages, and takes the first of these that is free and whose file is not stored.
  async function findLocks(names, files) {
    try {
      for (const lock of (await navigator.locks.query()).held) taken.add(lock.name);
      for (const [slot, name] of names.entries()) {
        const isEmpty = !storage()?.getItem(PREFIX + files[slot]);
        if (isEmpty && !taken.has(PREFIX + name)) {
          if (await hold(name)) return;
          taken.add(PREFIX + name);
        }
      }
    } catch { /* A browser without locks: its pages share their unsaved changes. */ } finally {
      done.push("locked");
    }
  }

  // Holds a lock until it is released. Tells whether it was free.
  function hold(name) {
    return new Promise((tell, fail) => {
      const hold = (lock) => {
        tell(lock !== null);
        return lock && new Promise((release) => releases.set(name, release));
      };
      navigator.locks.request(PREFIX + name, { ifAvailable: true }, hold).catch(fail);
    });
  }

  function lock(name) {
    if (taken.has(PREFIX + name)) return false;
    if (!releases.has(name) && navigator.locks) hold(name).catch(() => {});
    return true;
  }

  function unlock(name) {
    releases.get(name)?.();
    releases.delete(name);
  }

  function download(name, content) {
    const link = document.createElement("a");
    link.href = URL.createObjectURL(new Blob([content], { type: "application/octet-stream" }));
    link.download = name;
    link.click();
    setTimeout(() => URL.revokeObjectURL(link.href), 60000);
  }

  // The size of the largest file that is read into memory, in bytes.
  const LARGEST = 100 * 2 ** 20;

  // Takes files into the program's memory, and returns the path of the one to open: a scene or lesson, before
  // the tables that it names.
  async function take(files) {
    const paths = [];
    for (const file of files) {
      try {
        if (file.size > LARGEST) throw new Error(`it is too large: at most ${LARGEST / 2 ** 20} MiB are read`);
        paths.push(wasm_bindgen.file_added(file.name, new Uint8Array(await file.arrayBuffer())));
      } catch (error) {
        wasm_bindgen.file_refused(`${file.name}: ${error.message}`);
      }
    }
    return paths.find((path) => path.endsWith(".toml")) ?? paths[0];
  }

  function choose(extensions) {
    const input = document.createElement("input");
    Object.assign(input, { type: "file", accept: extensions, multiple: true });
    input.onchange = async () => { wasm_bindgen.choice_made(await take(input.files)); wake(); };
    input.oncancel = () => { wasm_bindgen.choice_made(); wake(); };
    input.click();
  }

  // WebKit tells a page from the disk no more of an error that nobody catches than that there was one: so what calls
  // the program catches it. Its first frame comes from an observer of the canvas.
  const guarded = (act) => (...parts) => {
    try {
      return act(...parts);
    } catch (error) {
      uncaught(error);
      throw error;
    }
  };
  window.ResizeObserver = class extends ResizeObserver {
    constructor(act) { super(guarded(act)); }
  };

  // The program's runner asks for an animation frame after each frame, even if nothing will change. While the
  // page rests, its request waits here.
  const request = window.requestAnimationFrame.bind(window);
  const WAITING = -1;
  let waiting = null;
  let isResting = false;
  let timer = 0;
  window.requestAnimationFrame = (frame) => {
    if (!isResting) return request(guarded(frame));
    waiting = guarded(frame);
    return WAITING;
  };
  const cancel = window.cancelAnimationFrame.bind(window);
  window.cancelAnimationFrame = (id) => {
    if (id === WAITING) waiting = null;
    else cancel(id);
  };

  function wake() {
    isResting = false;
    clearTimeout(timer);
    if (waiting) request(waiting);
    waiting = null;
  }

  // The longest delay of a timer, about 24 days.
  const LONGEST = 2 ** 31 - 1;

  let hasPicture = false;

  function rest(seconds) {
    if (!hasPicture) started();
    clearTimeout(timer);
    isResting = seconds > 0;
    if (isResting && seconds * 1000 < LONGEST) timer = setTimeout(wake, seconds * 1000);
  }

  const EVENTS = "pointerdown pointermove pointerup pointercancel pointerleave mousedown mousemove mouseup "
    + "touchstart touchmove touchend touchcancel wheel keydown keyup input compositionstart compositionend "
    + "copy cut paste dragover dragleave drop focus blur resize hashchange popstate pageshow";
  for (const type of EVENTS.split(" ")) window.addEventListener(type, wake, { capture: true, passive: true });
  new ResizeObserver(wake).observe(element("canvas"));
  for (const query of ["(prefers-color-scheme: dark)", `(resolution: ${devicePixelRatio}dppx)`]) {
    window.matchMedia(query).addEventListener("change", wake);
  }

  // A hidden page has no frames and needs no timers in their place, which the runner would set.
  window.addEventListener("visibilitychange", (event) => {
    event.stopImmediatePropagation();
    if (document.hidden) leave();
    wake();
  }, { capture: true });
  window.addEventListener("pagehide", leave);

  // Stores unsaved changes and settings. Before the program has started, there are none.
  function leave() {
    try { wasm_bindgen.page_hidden(); } catch { /* It has not started, or has failed. */ }
  }

  window.addEventListener("drop", async (event) => {
    if (!event.dataTransfer?.files.length) return;
    event.preventDefault();
    event.stopPropagation();
    const path = await take(event.dataTransfer.files);
    if (path) wasm_bindgen.file_dropped(path);
    wake();
  }, { capture: true });

  const fragment = () => location.hash.slice(1);

  // Takes the link out of the page's address, so that a reload shows what the user has done since.
  function forgetLink() {
    try {
      if (fragment()) history.replaceState(null, "", location.href.split("#")[0]);
    } catch { /* A page that has no address of its own keeps the link. */ }
  }

  window.addEventListener("hashchange", () => {
    const link = fragment();
    forgetLink();
    if (link) wasm_bindgen.link_opened(link);
    wake();
  });

  // Keys of the program that a browser would use for itself. F5 presents; Ctrl+R still reloads the page.
  window.addEventListener("keydown", (event) => {
    const isCommand = (event.ctrlKey || event.metaKey) && "be".includes(event.key.toLowerCase());
    if (isCommand || event.key === "F1" || event.key === "F5" && !event.ctrlKey) event.preventDefault();
  }, { capture: true });

  function fillScreen(fill) {
    const change = fill ? document.documentElement.requestFullscreen?.() : document.exitFullscreen?.();
    change?.catch(() => { /* Some browsers let no page fill the screen. */ });
  }

  document.addEventListener("fullscreenchange", () => {
    if (!document.fullscreenElement) wasm_bindgen.screen_left();
    wake();
  });

  // Chooses the keyboard on the screen for the element that takes the program's text. An iPhone's keyboard of
  // numbers lacks the minus.
  const NUMBERS = /iPhone|iPod/.test(navigator.userAgent) ? "text" : "decimal";

  function typeNumbers(isNumber) {
    const input = document.querySelector("input");
    const mode = isNumber ? NUMBERS : "text";
    if (input && input.inputMode !== mode) input.inputMode = mode;
  }

  function tell(text) {
    if (element("told").textContent !== text) element("told").textContent = text;
  }

  // Shows a message in place of the program. Each part of the text is a paragraph.
  function show(title, paragraphs, details = "", buttons = []) {
    const message = element("message");
    const add = (tag, text, parent = message) => {
      const child = parent.appendChild(document.createElement(tag));
      child.textContent = text;
      return child;
    };
    message.replaceChildren();
    add("h1", title);
    for (const text of paragraphs) add("p", text);
    if (details) add("pre", details);
    const row = add("div", "");
    for (const [name, act] of buttons) add("button", name, row).onclick = act;
    message.hidden = false;
    row.querySelector("button")?.focus();
  }

  const reportButtons = (report) => [
    ["Copy a report", () => navigator.clipboard.writeText(report).catch(() => download("pinhole-report.txt", report))],
    ["Save the report", () => download("pinhole-report.txt", report)],
  ];

  // True once the program has failed. What fails after that is a consequence.
  let isOver = false;
  let title = "Pinhole ran into an internal error";

  // `isKept` is undefined if the program could not be asked to store its changes.
  function failed(message, report, isKept) {
    isOver = true;
    window.requestAnimationFrame = () => WAITING;
    const lacks = hasPicture ? [] : missing();
    if (lacks.length) {
      show("This browser cannot run Pinhole", ["It lacks:", ...lacks.map((name) => "• " + name + "."),
        "Firefox 113, Chrome 113, Edge 113, Safari 16.4 and later ones have them all. If yours is later, the "
        + "settings of the browser or of the computer switch them off."]);
      return;
    }
    if (!isUsed && isKept && failures().length < STARTS - 1 && startAgain(message)) return;
    const kept = isKept ? "Unsaved changes are kept in the storage of this browser."
      : isKept === false ? "Unsaved changes could not be stored: save the report, which has the scene, before you go on."
      : "What you changed in the last seconds may be lost: the program can no longer be asked for it.";
    show(title, [kept], message, [["Go on", () => location.reload()], ...reportButtons(withBrowser(report))]);
  }

  // A start that fails before it is used is tried again. The marks of it are in the page's history,
  // which outlives a reload, and needs no storage and no address.
  const STARTS = 4;
  const failures = () => history.state?.failed ?? [];

  function startAgain(message) {
    try {
      history.replaceState({ failed: [...failures(), message] }, "");
    } catch {
      return false;
    }
    location.reload();
    return true;
  }

  function withBrowser(report) {
    const before = failures().map((message) => `A start before this one failed, too: ${message}\n`).join("");
    return `${navigator.userAgent}\n${before}${report}`;
  }

  function started() {
    hasPicture = true;
    performance.mark("first picture");
    if (!isOver) element("message").hidden = true;
    idle(() => rehearse(REHEARSAL));
  }

  // Once its user has done anything, or has had the time to, the program has started: an error is shown from then on,
  // and a reload shows what has been done since.
  let isUsed = false;

  function used() {
    if (isUsed || !hasPicture || isOver) return;
    isUsed = true;
    if (failures().length) history.replaceState(null, "");
    forgetLink();
  }
  for (const type of ["pointerdown", "keydown", "wheel", "drop", "paste", "hashchange"]) {
    window.addEventListener(type, used, { capture: true, passive: true });
  }

  const idle = window.requestIdleCallback?.bind(window) ?? ((act) => setTimeout(act, 20));

  // Before the user does so, a copy of the program that nobody sees drags *at* and looks round: where the pointer
  // is, and which button, the left one or the right one, is pressed or released there. The first makes the copy.
  const REHEARSAL = [[0, 0], [0, 0], [895, 384], [895, 384, true, true], [930, 355], [960, 330],
    [960, 330, true, false], [1200, 405], [1200, 405, false, true], [1280, 408], [1350, 411], [1350, 411, false, false]];

  // A frame at a time, so that it keeps nobody waiting.
  const rehearse = guarded(([[x, y, isLeft, isPressed = false], ...others]) => {
    if (isOver) return;
    const told = wasm_bindgen.rehearse(x, y, isLeft, isPressed, !others.length);
    if (others.length) return idle(() => rehearse(others));
    performance.mark("rehearsed", { detail: told });
    used();
  });

  // Ends the program. If it still can, it stores its changes and calls `failed`.
  function end(message) {
    if (isOver) return;
    try {
      wasm_bindgen.program_failed(message);
    } catch {
      // Before there is a picture, nothing can have been changed.
      failed(message, message, hasPicture ? undefined : true);
    }
  }

  const trace = (error) => `${error}\n${error?.stack ?? ""}`;

  // An error that nobody has caught. If it went through the program, that cannot go on. Extensions and learning
  // platforms have scripts of their own in this page, and what fails there is theirs.
  function uncaught(error) {
    if (/wasm/i.test(trace(error))) end(trace(error));
  }
  window.addEventListener("error", ({ error, message }) => {
    const isHidden = !error && !hasPicture && message === "Script error.";
    uncaught(isHidden ? "an error that the browser does not tell, perhaps in wasm" : error);
  });
  window.addEventListener("unhandledrejection", (event) => uncaught(event.reason));
  element("canvas").addEventListener("webglcontextlost", () => {
    title = "The browser has taken the picture away";
    end("WebGL: the context is lost");
  });

  // The seconds in sight after which a page without a picture says so. If the picture comes later, it is shown.
  const PATIENCE = 15;
  let seconds = 0;
  const patience = setInterval(() => {
    if (hasPicture || isOver) clearInterval(patience);
    else if (!document.hidden && (seconds += 1) === PATIENCE) {
      const report = `No picture after ${PATIENCE} s. Done: ${done.join(", ")}`;
      show("There is no picture yet", ["Pinhole has been starting for a quarter of a minute. It may only be slow here."],
        report, [["Try again", () => location.reload()], ...reportButtons(withBrowser(report))]);
    }
  }, 1000);

  // What the start has done, for a report.
  const done = [];

  // A module with one vector instruction.
  const VECTORS = new Uint8Array([0, 97, 115, 109, 1, 0, 0, 0, 1, 5, 1, 96, 0, 1, 123, 3, 2, 1, 0, 10, 10, 1, 8, 0,
    65, 0, 253, 15, 253, 98, 11]);

  // What the program needs and this browser lacks. It is asked after a failure: it takes a tenth of a second.
  function missing() {
    const has = {
      "WebGL 2, which draws the picture": () => document.createElement("canvas").getContext("webgl2"),
      "the vector instructions of WebAssembly, which trace the rays": () => WebAssembly.validate(VECTORS),
      "DecompressionStream, which unpacks the program": () => window.DecompressionStream,
    };
    return Object.keys(has).filter((name) => { try { return !has[name](); } catch { return true; } });
  }

  async function start() {
    const letters = atob(element("program").textContent);
    // A loop, because `Uint8Array.from` takes a third of a second for it.
    const packed = new Uint8Array(letters.length);
    for (let at = 0; at < letters.length; at += 1) packed[at] = letters.charCodeAt(at);
    done.push("decoded");
    const unpacked = new Blob([packed]).stream().pipeThrough(new DecompressionStream("gzip"));
    const headers = { "Content-Type": "application/wasm" };
    await wasm_bindgen({ module_or_path: new Response(unpacked, { headers }) });
    done.push("compiled");
  }

  window.addEventListener("DOMContentLoaded",
    () => start().catch((error) => end(trace(error))));

  return {
    now: () => Date.now(),
    stored: (key) => storage()?.getItem(PREFIX + key) ?? undefined,
    store,
    forget: (key) => storage()?.removeItem(PREFIX + key),
    find_locks: findLocks,
    lock,
    unlock,
    download,
    choose,
    part: () => element("part").textContent,
    source: () => source,
    address: () => location.href.split("#")[0],
    fragment,
    reduced_motion: () => window.matchMedia("(prefers-reduced-motion: reduce)").matches,
    set_title: (title) => { document.title = title; },
    fill_screen: fillScreen,
    type_numbers: typeNumbers,
    is_touched: () => window.matchMedia("(pointer: coarse)").matches,
    tell,
    rest,
    failed,
  };
})();
