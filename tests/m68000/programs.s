| Methods of Jansen 1987, section 4.3, and tasks of the host (docs/host.md), in assembly for the MC68000, as one would have
| written them by hand. A node of a tree:
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

| The five most expensive recipes of the host (hw/host/recipes.cpp), and a plane without tables. Numbers are signed longs. A product means its upper long,
| rounded down.

| Adds the product of d0 and d1 to d7. Takes d0 to d4.
        .macro  product
        tst.l   d0
        bpl.s   1f
        sub.l   d1,d7                   | the upper long of an unsigned product is too large by d1
1:      tst.l   d1
        bpl.s   2f
        sub.l   d0,d7
2:      move.l  d0,d2
        swap    d2
        move.l  d1,d3
        swap    d3
        move.w  d0,d4
        mulu    d1,d4
        clr.w   d4
        swap    d4
        mulu    d2,d1
        add.l   d4,d1                   | cannot overflow
        mulu    d3,d0
        mulu    d3,d2
        moveq   #0,d4
        move.w  d1,d4
        add.l   d4,d0                   | cannot overflow
        clr.w   d0
        swap    d0
        clr.w   d1
        swap    d1
        add.l   d0,d2
        add.l   d1,d2
        add.l   d2,d7
        .endm

| Adds the next component of a0 in the tables: its number at \first of the table's entry to d7, or, if more registers are
| named, the numbers there to these in order. A component is the address of its entry; bit 31, which the MC68000 does not
| put on its address lines, is its sign. Takes d0, a1.
        .macro  component first=0, sums:vararg=d7
        move.l  (a0)+,d0
        movea.l d0,a1
        bmi.s   1f
        .set    at, \first
        .irp    sum,\sums
        add.l   at(a1),\sum
        .set    at, at + 4
        .endr
        bra.s   2f
1:      .set    at, \first
        .irp    sum,\sums
        sub.l   at(a1),\sum
        .set    at, at + 4
        .endr
2:
        .endm

| A direction of three components at a0, whose entries have three products each. At a2 the result: a reciprocal (a long), its
| number of places (a word), and two slopes (longs), the first two sums divided by the third, with 12 more places. If the third
| is less than 8192, the reciprocal is 0 and the slopes are the sums. Takes all data registers, a0 to a3.
quotient:
        moveq   #0,d5
        moveq   #0,d6
        moveq   #0,d7
        .rept   3
        component 0,d5,d6,d7
        .endr
| The same of the three sums in d5, d6, d7.
slopes: move.l  d7,d2
        bpl.s   3f
        neg.l   d2
3:      cmpi.l  #8192,d2
        bcs     5f
        moveq   #17,d4                  | the places that the products are shifted back
4:      add.l   d2,d2                   | until bit 31 is 1
        dbmi    d4,4b
        lsr.l   #1,d2
        move.l  #0x1fffffff,d0
        moveq   #-1,d1
        bsr     divide_long
        tst.l   d7
        bpl.s   3f
        neg.l   d1
3:      move.l  d1,(a2)+
        move.w  d4,(a2)+
        movea.l d1,a1
        movea.w d4,a3
        .irp    dividend,d5,d6
        move.l  \dividend,d0
        move.l  a1,d1
        moveq   #0,d7
        product
        move.l  a3,d0
        asr.l   d0,d7
        move.l  d7,(a2)+
        .endr
        rts
5:      clr.l   (a2)+
        clr.w   (a2)+
        move.l  d5,(a2)+
        move.l  d6,(a2)+
        rts

| A plane at a0: its offset, three components, and the address of its direction's result. Their entries have the product for
| the offset as the fourth. The sum, divided like the slopes, is stored at a2. Takes d0 to d4, d7, a0, a1.
plane:
        move.l  (a0)+,d7
        .rept   3
        component 12
        .endr
        movea.l (a0)+,a1
scaled: move.l  (a1)+,d1
        beq.s   3f
        move.l  d7,d0
        moveq   #0,d7
        product
        move.w  (a1),d0
        asr.l   d0,d7
3:      move.l  d7,(a2)
        rts

| A plane without tables, as the display processor of the multi-processor transforms it (hw/host/node_recipes.cpp): the normal
| a4, a5, a6; at a0 the offset and four rows of a matrix, for the offset and the three sums. At a2 the result of the direction
| and the plane's. Takes d0 to d7, a0 to a3.
own_plane:
        .macro  row
        .irp    part,a4,a5,a6
        move.l  (a0)+,d0
        move.l  \part,d1
        product
        .endr
        .endm
        move.l  (a0)+,d7
        row
        move.l  d7,-(sp)
        .irp    sum,d5,d6
        moveq   #0,d7
        row
        move.l  d7,\sum
        .endr
        moveq   #0,d7
        row
        bsr     slopes
        move.l  (sp)+,d7
        lea     -14(a2),a1
        bra     scaled

| The colour d6 of a facet with the normal, three longs at a0, in the light a4, a5, a6, of a surface with three longs at a1: a
| byte for each channel. Takes all data registers.
colour:
        moveq   #0,d7
        .irp    light,a4,a5,a6
        move.l  (a0)+,d0
        move.l  \light,d1
        product
        .endr
        tst.l   d7
        bpl.s   3f
        moveq   #0,d7
3:      move.l  d7,d5                   | the light that arrives
        moveq   #0,d6
        .rept   3
        moveq   #0,d7
        move.l  d5,d0
        move.l  (a1)+,d1
        product
        cmpi.l  #255,d7
        bls.s   4f
        move.l  #255,d7
4:      lsl.l   #8,d6
        or.l    d7,d6
        .endr
        rts

| The point of three longs at a0 in the direction a4, a5, a6: d7. d6 becomes the larger of both. Takes d0 to d4.
support:
        moveq   #0,d7
        .irp    direction,a4,a5,a6
        move.l  (a0)+,d0
        move.l  \direction,d1
        product
        .endr
        cmp.l   d6,d7
        ble.s   3f
        move.l  d7,d6
3:      rts

| The half-space of three longs A, B, C at a0 at the corners of the rectangle of four words x, y, width and height at a1: d5
| becomes the least, d6 the greatest of the values. Takes d0 to d7.
        .macro  long_by_word            | d0 becomes the long d0 times the word d1; takes d2
        move.l  d0,d2
        mulu    d1,d0
        swap    d2
        mulu    d1,d2
        swap    d2
        clr.w   d2
        add.l   d2,d0
        .endm
        .macro  corner
        cmp.l   d5,d7
        bge.s   1f
        move.l  d7,d5
1:      cmp.l   d6,d7
        ble.s   2f
        move.l  d7,d6
2:
        .endm
halfspace:
        move.l  (a0),d3
        move.l  4(a0),d4
        move.l  8(a0),d7
        move.l  d3,d0
        move.w  (a1),d1
        long_by_word
        add.l   d0,d7
        move.l  d4,d0
        move.w  2(a1),d1
        long_by_word
        add.l   d0,d7                   | at x, y
        move.l  d3,d0
        move.w  4(a1),d1
        long_by_word
        move.l  d0,d3                   | the change along the width
        move.l  d4,d0
        move.w  6(a1),d1
        long_by_word                    | along the height
        move.l  d7,d5
        move.l  d7,d6
        add.l   d3,d7                   | at the other end of the width
        corner
        add.l   d0,d7                   | and of the height
        corner
        sub.l   d3,d7
        corner
        rts
