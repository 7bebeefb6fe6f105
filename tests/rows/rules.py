#!/usr/bin/env python3
"""Rules of DDR4-2400 (8 Gbit, x8, 17-17-17), written down from the data sheet, against traces of csgsim.

check_commands() verifies a list of DRAM commands; schedule() issues the row commands of a trace again, as early as the
rules allow, and returns its own number of clocks.
"""

RCD, RP, RAS, RRD, FAW, RTP, WR_TO_PRE, CCD, RFC, REFI = 17, 17, 39, 4, 26, 9, 12 + 4 + 18, 4, 420, 9360
COLUMN, RECOVERY, GATE, SECOND = 34, 18, 4, 5  # RCD + CL; WR; a gate; a second activation of Ambit
BUS_BITS, CHIPS = 16, 8


def check_commands(commands, allows_second=True):
    """commands: (clock, name, bank) in order. Returns a list of violations and the number of checked distances."""
    faults, checked = [], 0
    opened, closed, column, recent = {}, {}, {}, []
    refreshed, last, refreshes = None, 0, []

    def need(clock, since, distance, rule):
        nonlocal checked
        if since is None:
            return
        checked += 1
        if clock - since < distance:
            faults.append(f"{rule}: {clock - since} < {distance} clocks at {clock}")

    for clock, name, bank in commands:
        if clock < last:
            faults.append(f"order: {clock} after {last}")
        last = clock
        if name == "ACT":
            if bank in opened and not (allows_second and clock - opened[bank][-1] >= RRD and len(opened[bank]) == 1):
                faults.append(f"ACT of the open bank {bank} at {clock}")
            need(clock, closed.get(bank), RP, "tRP")
            need(clock, recent[-1] if recent else None, RRD, "tRRD")
            need(clock, recent[-4] if len(recent) > 3 else None, FAW, "tFAW")
            need(clock, refreshed, RFC, "tRFC")
            recent.append(clock)
            opened.setdefault(bank, []).append(clock)
        elif name == "PRE":
            if bank not in opened:
                faults.append(f"PRE of the closed bank {bank} at {clock}")
                continue
            need(clock, opened[bank][-1], RAS, "tRAS")
            kind, at = column.pop(bank, (None, None))
            need(clock, at, RTP if kind == "RD" else WR_TO_PRE, "tRTP or tWR")
            closed[bank] = clock
            del opened[bank]
        elif name in ("RD", "WR"):
            if bank not in opened:
                faults.append(f"{name} of the closed bank {bank} at {clock}")
                continue
            need(clock, opened[bank][0], RCD, "tRCD")
            need(clock, max((at for _, at in column.values()), default=None), CCD, "tCCD")
            column[bank] = (name, clock)
        elif name == "REFA":
            faults += [f"REFA with bank {one} open at {clock}" for one in opened]
            for at in closed.values():
                need(clock, at, RP, "tRP")
            need(clock, refreshed, RFC, "tRFC")
            refreshed = clock
            refreshes.append(clock)
            if clock > 9 * REFI + (refreshes[-9] if len(refreshes) > 8 else 0):
                faults.append(f"tREFI: more than eight refreshes are postponed at {clock}")
        elif name != "END":
            faults.append(f"unknown command {name}")
    if last // REFI > len(refreshes):
        faults.append(f"tREFI: {len(refreshes)} refreshes in {last} clocks")
    return faults, checked


class Rank:
    """Issues row commands in order to all slots, each as early as the rules allow. Slots take turns in the banks."""

    def __init__(self, slots, columns, banks, pixels):
        self.slots = [(slot % banks, min(columns, pixels - slot * columns)) for slot in range(slots)]
        self.free = dict.fromkeys({bank for bank, _ in self.slots}, 0)
        self.recent, self.bus, self.due = [], 0, REFI

    def activate(self, earliest):
        recent = self.recent
        at = max([earliest] + [one + RRD for one in recent[-1:]] + [one + FAW for one in recent[-4:-3]])
        self.recent = recent[-3:] + [at]
        return at

    def refresh(self):
        begin = max(list(self.free.values()) + [self.bus])
        self.due += REFI
        self.free = dict.fromkeys(self.free, begin + RFC)

    def gate(self, clocks):
        self.free = {bank: at + clocks for bank, at in self.free.items()}

    def command(self, op):
        if op != "WRITE" and self.free[0] >= self.due:
            self.refresh()
        for bank, pixels in self.slots:
            at = self.activate(self.free[bank])
            if op == "AAP":
                at = self.activate(at + SECOND)
            close = at + RAS
            if op == "SEND":
                self.bus = max(self.bus, at + COLUMN) + -(-pixels // (BUS_BITS * CHIPS))
                close = max(close, self.bus + RECOVERY)
            self.free[bank] = close + RP

    def settle(self, extra):
        """Waits until all banks are closed and the window of four activations is empty, and `extra` clocks more."""
        now = max(list(self.free.values()) + [self.bus] + [one + FAW for one in self.recent[-4:]])
        self.free = dict.fromkeys(self.free, now + extra)
        return now


def schedule(lines):
    """Issues the commands of a trace in the form csgsim again, without its clocks. Returns the clock of the end.

    An instruction begins one clock after the previous one has ended in all banks. Waiting for the host is left out.
    """
    rank, pixels, end, gates = None, 0, 0, {}
    for line in lines:
        words = line.split()
        if words[0] == "picture":
            pixels = int(words[1]) * int(words[2])
        elif words[0] == "slots":
            rank = Rank(int(words[1]), int(words[2]), int(words[3]), pixels)
        elif words[0] == "gate":
            gates[words[1]] = int(words[3])
        elif words[0] in ("segment", "instruction"):
            rank.settle(1)
        elif words[0] == "scan_out":
            rank.settle(0)
        elif words[0] == "end":
            end = rank.settle(0)
        elif words[0].isdigit() and words[1] == "0" and words[2] in ("0", "*"):
            if words[5] == "LOGIC":
                rank.gate(gates[words[8]] if gates else GATE)
            else:
                rank.command(words[5])
    return end


def different_sequences(lines):
    """Slots whose commands differ from those of the first; all must execute the same commands in the same order."""
    executed = {}
    for line in lines:
        words = line.split()
        if words[0].isdigit() and words[2] not in ("*",):
            text = " ".join(words[5:words.index("bus") if "bus" in words else None])
            executed.setdefault((words[1], words[2]), []).append(text)
    return [place for place, texts in executed.items() if texts != executed[("0", "0")]]
