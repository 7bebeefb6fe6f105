// Processor operations per task of a processor that divides a model and draws it at pixels.
// Used by hw/multi_processor and tests.
#pragma once

#include "hw/processors/operations.h"

// Operations of the nodes and the display processor of a multi-processor, assumed like those of the host. Tasks that
// the host does too have its recipes.
namespace csgsim::host {

/// A plane of the model transformed: the host's `quotients` and `planes`, with 12 products that are not kept in tables.
processors::Operations transformed_plane();
processors::Operations tested_box();            ///< a primitive's box against a part of the picture: the host's `boxes`
processors::Operations tested_halfspace();      ///< a half-space at the corners of a part: the host's `tests`
processors::Operations tested_cell();           ///< a half-space against the leaders of a cell
processors::Operations visited_node();          ///< a node of the tree with its box: the host's `nodes` and `boxes`
processors::Operations listed_instruction();    ///< an instruction with its expression appended to a list
processors::Operations listed_number();         ///< an instruction with the number of a half-space appended to a list
processors::Operations found_field();           ///< the place of the next number in packed bits
processors::Operations linked_call();           ///< a call appended to a native program
processors::Operations called();                ///< a call of a native program, and its return
processors::Operations repeated_pixel();        ///< an iteration of the loop over the pixels of a row
processors::Operations repeated_row();          ///< an iteration of the loop over rows
processors::Operations repeated_instruction();  ///< an iteration of the loop over instructions, with its opcode

}  // namespace csgsim::host
