/* The methods of ../programs.s in C, to measure compiled code: docs/host.md. */

enum { primitive, set_union, difference, intersection };

struct node {
  short kind;
  short number; /* number of a leaf's primitive */
  short status; /* for a status tree: 0 out, -1 in */
  struct node *left, *right;
  struct node *father; /* for a status tree: 0 in the root */
  short middle;        /* for positional coding: first code of the right side */
  short last;          /* for positional coding: last code of the node */
};

short statuses[1024]; /* by primitive */
struct node *leaves[1024];

struct levels {
  short count;
  unsigned long inverted[5];
};

enum { no_code = 0x7fff };
short list[1026]; /* codes of the primitives around the point, sorted; ends with no_code */
short codes[1024]; /* by primitive */

unsigned long status_bits;
unsigned long bits[32]; /* by primitive */

short standard(struct node *node) {
  short left, right;
  if (node->kind == primitive) return statuses[node->number];
  left = standard(node->left);
  right = standard(node->right);
  switch (node->kind) {
    case set_union:
      return left | right;
    case difference:
      return left & ~right;
    default:
      return left & right;
  }
}

short early_out(struct node *node) {
  short left;
  if (node->kind == primitive) return statuses[node->number];
  left = early_out(node->left);
  switch (node->kind) {
    case set_union:
      if (left) return left;
      return early_out(node->right);
    case difference:
      if (!left) return left;
      return ~early_out(node->right);
    default:
      if (!left) return left;
      return early_out(node->right);
  }
}

void invert(short number) { statuses[number] = ~statuses[number]; }

void flip_status(short number) {
  struct node *node;
  short status;
  node = leaves[number];
  node->status = ~node->status;
  for (node = node->father; node; node = node->father) {
    switch (node->kind) {
      case set_union:
        status = node->left->status | node->right->status;
        break;
      case difference:
        status = node->left->status & ~node->right->status;
        break;
      default:
        status = node->left->status & node->right->status;
        break;
    }
    if (status == node->status) return;
    node->status = status;
  }
}

short look(struct node *node) { return node->status; }

/* The status is the highest bit of the result. */
unsigned long bit_parallel(struct levels *levels) {
  unsigned long result;
  short level, places;
  result = status_bits;
  places = 1;
  for (level = 0; level < levels->count; level++) {
    result ^= levels->inverted[level];
    result &= result << places;
    result ^= levels->inverted[level];
    places += places;
  }
  return result;
}

void invert_bit(short number) { status_bits ^= bits[number]; }

static short *next;
static short code; /* the code to search for */

/* Evaluates a node that has the code. */
static short find(struct node *node) {
  short left, status;
  if (node->kind == primitive) {
    code = *next++;
    return -1;
  }
  left = 0;
  if (code < node->middle) left = find(node->left);
  if (node->kind == set_union ? !left : left) {
    status = code <= node->last ? find(node->right) : 0;
    return node->kind == difference ? ~status : status;
  }
  while (code <= node->last) code = *next++;
  return left;
}

short positional(struct node *node) {
  next = list;
  code = *next++;
  if (code > node->last) return 0;
  return find(node);
}

void change_list(short number) {
  short *at;
  short moved, other;
  moved = codes[number];
  at = list;
  while (*at < moved) at++;
  if (*at == moved) {
    do {
      at[0] = at[1];
    } while (*at++ != no_code);
    return;
  }
  while (moved != no_code) {
    other = *at;
    *at++ = moved;
    moved = other;
  }
  *at = no_code;
}
