#!/usr/bin/env python3
"""Measures how many pictures per second the page without a server program shows in a headless Chromium while a model is
turned: speed.py SITE. Prints a table."""

import json
import pathlib
import sys

SITE = pathlib.Path(sys.argv[1]).resolve()
SOURCE = pathlib.Path(__file__).resolve().parents[2]
sys.path[:0] = [str(SOURCE / "tests/report"), str(SOURCE / "tests/view")]

import browser  # noqa: E402
from speed import PICTURES, ROWS, turned  # noqa: E402
from web_page import StaticServer  # noqa: E402

TURN = """(async () => {
  const {ask} = await import('./asking.js');
  const requests = REQUESTS;
  const draw = async request => {
    const {isGood, answer} = await ask('draw', request);
    if (!isGood) throw new Error(answer.error);
    const picture = document.getElementById('picture');
    picture.src = answer.picture;
    await picture.decode();
    return answer.seconds;
  };
  await draw(requests[0]);
  const begin = performance.now();
  const parts = {compiling: 0, running: 0};
  for (const request of requests.slice(1)) {
    const seconds = await draw(request);
    for (const part in parts) parts[part] += seconds[part];
  }
  return {whole: (performance.now() - begin) / 1000, ...parts};
})()"""


def main():
    server = StaticServer(SITE)
    page = browser.Browser(browser.find())
    print("| model | machine | pictures per second | compiling, share of time | running |\n|---|---|--:|--:|--:|")
    try:
        for model, camera, knobs in ROWS:
            page.send("Page.navigate", url=f"{server.address}?model={model}.csg&size=64x64")
            while not page.evaluate("window.isAtRest && window.isAtRest()"):
                pass
            requests = [{"knobs": knobs | {"size": "512x512", "camera": turned(camera, 3 * number)}} for number in range(PICTURES + 1)]
            took = page.evaluate(TURN.replace("REQUESTS", json.dumps(requests)))
            shares = " | ".join(f"{100 * took[part] / took['whole']:.0f} %" for part in ("compiling", "running"))
            print(f"| {model} | {knobs.get('machine', 'pixel-planes-4')} | {PICTURES / took['whole']:.1f} | {shares} |")
    finally:
        page.close()
        server.stop()


if __name__ == "__main__":
    main()
