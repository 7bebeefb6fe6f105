"""The exercises of docs/lessons.md: answers by hand, and the commands that show them."""

import re

import by_hand

from .one_pixel_story import MODEL, STEPS, VIEW, X, Y, Differs, compiled, is_in, last_keep, story, stream_and_hand

SAME_VIEW = '"${VIEW[@]}"'  # the page's VIEW, in bash and in zsh


def debug(*lines):
    return "printf '" + "".join(f"{each}\\n" for each in lines) + "' | csgsim debug step.csgt"


def render(told, options):
    """A command that draws the model with other options, and prints selected lines of its costs."""
    return f"csgsim render $MODEL {SAME_VIEW} --z-bits 8 {options} | grep {told}"


def solved(told_by, coarse):
    """The answers by hand: (words, command, expected output)."""
    hand, keep = told_by.hand, last_keep(told_by)
    at = {name: told_by.step(name) for name in STEPS}
    nearer, left = (sum(now.mask for now in at[f"B {name}"].after.values()) for name in ("test", "mask"))
    side = hand.front("A", 3, 11)
    face = hand.facet("A", by_hand.FRONTS, side, 3, 11)
    floor = hand.pixel(7, 8)[-1][1].z2
    taken = told_by.stream[keep].clocks
    before = at["N in A shade"].after[X, Y]
    shallow = coarse.pixel(X, Y)[-1][1].z2
    bits = sum(map(int, re.findall(r"^\.field \w+ \[\d+\+:(\d+)\]", told_by.listing, re.MULTILINE))) + 1
    rebroadcast = told_by.stats.clocks
    return [
        (f"{side}; {is_in('A', face)}", debug("until i12", "print Z1[3,11]"), [f"Z1[3,11] = {side} "]),
        (f"N's plane {is_in('N', hand.facet('N', by_hand.BACKS, floor, 7, 8))}, at depth {floor}", "csgsim explain step.csgt --pixel 7,8 | head -3",
         ["shows p2 cube@17:5", f"depth     {floor} steps"]),
        (f"{nearer}; N takes {nearer - left} of them", debug(f"until i{at['B skip'].first}", "print E", f"until i{at['B merge'].first}", "print E"),
         [f"E = 1 at {nearer} of 256", f"E = 1 at {left} of 256"]),
        (f"{taken}: {taken // 2} bits, twice", debug(f"until i{keep}", "where"), []),
        (f"A's top: {before.z2}, `#{before.colour:06x}`", debug(f"until i{at['N in B test'].first}", f"print {X},{Y}"),
         [f"Z2           {before.z2} ", f"#{before.colour:06x}"]),
        (f"{shallow}", f"csgsim explain $MODEL {SAME_VIEW} --z-bits 6 --strategy bits --pixel {X},{Y} | sed -n 2p", [f"depth     {shallow} steps"]),
        (f"{bits + 24} bits; {{clocks:,}} clocks instead of {rebroadcast:,}", render("-E '^(drawn|memory)'", "--strategy bits --colouring field"),
         [f"memory            {bits + 24} of 72 bits"]),
        (f"{{clocks:,}} clocks instead of {rebroadcast:,}, for {bits + 1} bits; N is tested, merged and shaded once, for A ∪ B",
         render("-E '^(drawn|scan|memory)'", "--strategy stack --verbose"), ["3 depth tests", f"memory            {bits + 1} of 72 bits"]),
    ]


def issued(printed):
    """The number of clocks in which an instruction is issued, from csgsim debug."""
    first, last = re.search(r"issued in clocks (\d+)\.\.(\d+)", printed).groups()
    return int(last) - int(first) + 1


def answers(figures):
    """Each answer, with the command that shows it, which is run: its output must contain the answer."""
    runs = figures.runs
    rows = []
    for n, (words, command, wanted) in enumerate(solved(story(figures), stream_and_hand(runs, 6)[2]), 1):
        printed = runs.run(f"MODEL={MODEL}; VIEW=({VIEW}); {compiled(8)}; R=$PWD; cd $OUT; ln -s $R/tests tests; {command}").printed
        for each in wanted:
            if each not in printed:
                raise Differs(f"exercise {n}: '{each}' is not in what '{command}' prints:\n{printed}")
        if "issued in" in printed and not words.startswith(f"{issued(printed)}:"):
            raise Differs(f"exercise {n}: {words}, but it takes {issued(printed)} clocks")
        counted = re.search(r"^drawn .*\(([\d,]+) clocks\)", printed)
        rows.append(f"{n}. {words.format(clocks=int(counted[1].replace(',', '')) if counted else 0)}: `{command}`")
    return "\n".join(rows)
