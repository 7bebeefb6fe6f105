"""What the page of a run tells of a pixel, and the same from `csgsim explain`, in forms that can be compared."""

import json
import re
import subprocess

# The story of a pixel as the page's script has it, by the keys of `csgsim explain --json`.
STORY = """((x, y) => {
  const {program} = csgsimDrawings[0];
  const whole = value => typeof value === 'bigint' ? String(value) : value;
  const owner = piece => piece < 0 ? null : pixelStory.primitiveOf(program, piece);
  const decision = one => one && {instruction: one.number, text: one.instruction.text, value: one.instruction.linear ? whole(one.value) : undefined,
    met: one.instruction.fields[0].width ? whole(one.met) : undefined, met_too: one.instruction.fields[1].width ? whole(one.metToo) : undefined};
  const story = pixelStory.of(program, x, y);
  const words = new storyWords.Words(program);
  return {owner: owner(story.owner), depth: story.depth, colour: words.colour(story.colour), segments: story.segments,
    events: story.events.map(event => ({what: event.what, first: event.first, last: event.last, primitive: owner(event.origin.primitive), against: owner(event.origin.node),
      enabled: [event.isEnabledBefore, event.isEnabledAfter], decision: decision(event.decision), cut: decision(event.cut),
      changes: event.changes.map(change => [words.field(change.field), whole(change.before), whole(change.after), change.number]), owner: [owner(event.ownerBefore), owner(event.ownerAfter)]})),
    surfaces: story.attempts.map(one => ({primitive: owner(one.shown), fate: one.fate, events: [one.firstEvent, one.lastEvent], deciding_event: one.decidingEvent, text: words.fate(story, one)}))};
})"""


def index(primitive):
    return primitive["index"] if primitive else None


def steps(value):
    """A number, or the steps of a depth."""
    return value["steps"] if isinstance(value, dict) else value


def decision(told):
    if told is None:
        return None
    return {key: told[key] for key in ("instruction", "text", "value", "met", "met_too") if key in told}


def of_explain(told):
    """`csgsim explain --json`, by what the page tells too."""
    return {
        "owner": index(told["owner"]), "depth": told["depth"]["steps"], "colour": told["colour"], "segments": [part["segment"] for part in told["segments"]],
        "events": [{"what": event["what"], "first": event["first"], "last": event["last"], "primitive": index(event.get("primitive")), "against": index(event.get("against")),
                    "enabled": event["enabled"], "decision": decision(event.get("decision")), "cut": decision(event.get("cut")),
                    "changes": [[change["field"], steps(change["before"]), steps(change["after"]), change["instruction"]] for change in event["changes"]],
                    "owner": [index(owner) for owner in event["owner"]]} for event in told["events"]],
        "surfaces": [{"primitive": index(one["primitive"]), "fate": one["fate"], "events": one["events"], "deciding_event": one["deciding_event"], "text": one["text"]}
                     for one in told["surfaces"]]}


def explained(csgsim, subject, pixel, *words):
    """The JSON, and the text as lines without columns and clocks, which the page does not tell."""
    command = [csgsim, "explain", *subject, "--pixel", f"{pixel[0]},{pixel[1]}", *words]
    told = json.loads(subprocess.run([*command, "--json", "-"], check=True, text=True, capture_output=True).stdout)
    text = subprocess.run(command, check=True, text=True, capture_output=True).stdout
    lines = []
    for line in text.split("\n"):
        line = re.sub(r"^( *i\d+(?:\.\.i\d+)?) +(?:\d+\.\.\d+|-)  ", r"\1  ", line)
        line = re.sub(r", clocks \d+\.\.\d+", "", " ".join(line.split()))
        if line and not re.fullmatch(r"clocks|segment \d+.*", line):
            lines.append(line)
    return told, lines


# What is shown of a pixel's story, line by line.
SHOWN = """[...csgsimDrawings[0].why.story.querySelectorAll('strong, .facts li, .events li, p.note')].flatMap(element => {
  const button = element.querySelector('button');
  if (!button) return [element.textContent.replace('⇒', '=>')];
  const [first, ...more] = [...element.lastElementChild.childNodes].map(node => node.textContent);
  return [button.textContent + ' ' + element.querySelector('.what').textContent + ' ' + first, ...more];
}).flatMap(text => text.split('\\n')).map(line => line.split(/\\s+/).join(' ').trim()).filter(line => line && !/^segment \\d+/.test(line))"""
