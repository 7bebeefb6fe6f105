| Methods of Jansen 1987, section 4.3, in assembly for the MC68000, as one would have written them by hand. A node of a tree:
        .equ    kind, 0                 | a word: 0 a primitive, 1 a union, 2 a difference, 3 an intersection
        .equ    number, 2               | a word of a leaf: 2 times the number of its primitive
        .equ    status, 4               | a word, of a status tree: 0 out, -1 in
        .equ    left, 6                 | a long: the address of a node
        .equ    right, 10
        .equ    father, 14              | of a status tree: 0 of the root
        .equ    middle, 18              | words, of positional coding: the first code of the right side,
        .equ    last, 20                | and the last of the node
        .equ    no_code, 0x7fff         | behind the codes of a list, and more than each
| a1 points to a table with a word a primitive, its status, 0 or -1; of a status tree to one with a long, its leaf.
        .text

| Standard: every node in postorder. a0 is the node; d0 becomes its status. Takes a0, d1.
standard:
        move.w  (a0),d1
        beq.s   1f
        move.l  a0,-(sp)
        movea.l left(a0),a0
        bsr.s   standard
        movea.l (sp),a0
        move.w  d0,-(sp)                | what the left one is
        movea.l right(a0),a0
        bsr.s   standard
        move.w  (sp)+,d1
        movea.l (sp)+,a0
        cmpi.w  #2,(a0)
        bcs.s   2f
        beq.s   3f
        and.w   d1,d0
        rts
2:      or.w    d1,d0
        rts
3:      not.w   d0
        and.w   d1,d0
        rts
1:      move.w  number(a0),d0
        move.w  0(a1,d0.w),d0
        rts

| Early out: the right one only where the left one does not decide. As above.
early_out:
        move.w  (a0),d1
        beq.s   1f
        move.l  a0,-(sp)
        movea.l left(a0),a0
        bsr.s   early_out
        movea.l (sp)+,a0
        cmpi.w  #2,(a0)
        bcs.s   2f
        beq.s   3f
        tst.w   d0                      | intersection
        beq.s   4f
        bra.s   5f
2:      tst.w   d0                      | union
        bne.s   4f
5:      movea.l right(a0),a0
        bsr.s   early_out
        rts
3:      tst.w   d0                      | difference
        beq.s   4f
        movea.l right(a0),a0
        bsr.s   early_out
        not.w   d0
4:      rts
1:      move.w  number(a0),d0
        move.w  0(a1,d0.w),d0
        rts

| A primitive, d0, changes its status, for both.
invert:
        add.w   d0,d0
        not.w   0(a1,d0.w)
        rts

| Status tree: the primitive, d0, changes its status, and so do those of its ancestors that depend on it. Takes a0, a2, d0,
| d1.
flip_status:
        add.w   d0,d0
        add.w   d0,d0
        movea.l 0(a1,d0.w),a0
        not.w   status(a0)
1:      move.l  father(a0),d0
        beq.s   4f
        movea.l d0,a0
        movea.l right(a0),a2
        move.w  status(a2),d0
        movea.l left(a0),a2
        cmpi.w  #2,(a0)
        bcs.s   2f
        bne.s   3f
        not.w   d0
3:      and.w   status(a2),d0
        bra.s   5f
2:      or.w    status(a2),d0
5:      cmp.w   status(a0),d0
        beq.s   4f
        move.w  d0,status(a0)
        bra.s   1b
4:      rts

| The status, d0, of the node a0.
look:
        move.w  status(a0),d0
        rts

| Bit-parallel: all nodes of a level at once, in a fully developed tree of 32 leaves at most, of which the first is the highest
| bit. a1 points to a long, the status of all primitives; a0 to a word, the number of levels less 1, and behind it a long a
| level, from the leaves up: the bits that are inverted before and after. d0 becomes the status of the root, its highest bit.
| Takes a0, d1 to d4.
bit_parallel:
        move.l  (a1),d0
        move.w  (a0)+,d1
        moveq   #1,d2
1:      move.l  (a0)+,d3
        eor.l   d3,d0
        move.l  d0,d4
        lsl.l   d2,d4                   | the right one to the left one
        and.l   d4,d0
        eor.l   d3,d0
        add.w   d2,d2
        dbra    d1,1b
        rts

| The primitive, d0, changes its status, for that; a2 points to a table with a long a primitive, its bit.
invert_bit:
        add.w   d0,d0
        add.w   d0,d0
        move.l  0(a2,d0.w),d0
        eor.l   d0,(a1)
        rts

| Positional coding: only sides with a primitive that is in. a0 is the root; a1 points to a list of words, the codes of the
| primitives that are in, in their order, behind them no_code. d0 becomes the status of the root. Takes a0, a1, d2.
positional:
        move.w  (a1)+,d2                | the code that is searched for
        cmp.w   last(a0),d2
        bls.s   find
        moveq   #0,d0
        rts
| Of a node that has the code.
find:
        tst.w   (a0)
        beq.s   6f
        cmp.w   middle(a0),d2
        bcc.s   1f
        move.l  a0,-(sp)
        movea.l left(a0),a0
        bsr.s   find
        movea.l (sp)+,a0
        tst.w   d0
        beq.s   1f
        cmpi.w  #2,(a0)                 | the left side is in
        bcs.s   4f
        bhi.s   2f
        cmp.w   last(a0),d2             | difference
        bhi.s   5f
        movea.l right(a0),a0
        bsr.s   find
        not.w   d0
5:      rts
1:      cmpi.w  #2,(a0)                 | the left side is out
        bcc.s   3f
2:      cmp.w   last(a0),d2             | as the right side
        bhi.s   7f
        movea.l right(a0),a0
        bsr.s   find
        rts
7:      moveq   #0,d0
        rts
3:      moveq   #0,d0                   | decided: what is left of the node's codes is skipped
        bra.s   8f
9:      move.w  (a1)+,d2
8:      cmp.w   last(a0),d2
        bls.s   9b
        rts
4:      moveq   #-1,d0
        bra.s   8b
6:      move.w  (a1)+,d2                | a leaf
        moveq   #-1,d0
        rts

| The primitive, d0, changes its status, for that: its code comes into the list, or leaves it. a2 points to a table with a
| word a primitive, its code.
change_list:
        add.w   d0,d0
        move.w  0(a2,d0.w),d0
1:      move.w  (a1)+,d1
        cmp.w   d0,d1
        bcs.s   1b
        beq.s   3f
2:      move.w  d0,-2(a1)
        cmpi.w  #no_code,d0
        beq.s   4f
        move.w  d1,d0
        move.w  (a1)+,d1
        bra.s   2b
3:      move.w  (a1)+,d1
        move.w  d1,-4(a1)
        cmpi.w  #no_code,d1
        bne.s   3b
4:      rts

| A number of 64 bits, d0 and d1, divided by the long d2, which is more than d0 and at most 2 to the 31st: d1 becomes the
| quotient, d0 the remainder. Takes d3.
divide_long:
        moveq   #31,d3
1:      add.l   d1,d1
        roxl.l  #1,d0
        cmp.l   d2,d0
        bcs.s   2f
        sub.l   d2,d0
        addq.w  #1,d1
2:      dbra    d3,1b
        rts
