// Processor operations per task of a processor that divides a model and draws it at pixels.
// Used by hw/multi_processor and tests.
#pragma once

#include "hw/processors/operations.h"

// Operations of the nodes and the display processor of a multi-processor, assumed like those of the host. Tasks that
// the host does too have its recipes.
namespace csgsim::host {

/// A plane of the model transformed: the host's `quotients` and `planes`, with 12 products that are not kept in tables.
processors::Operations plane_transform_operations();
processors::Operations box_test_operations();  ///< a primitive's box against a part of the picture: the host's `boxes`
processors::Operations halfspace_test_operations();  ///< a half-space at the corners of a part: the host's `tests`
processors::Operations cell_test_operations();       ///< a half-space against the leaders of a cell
processors::Operations node_visit_operations();  ///< a node of the tree with its box: the host's `nodes` and `boxes`
processors::Operations instruction_listing_operations();  ///< an instruction with its expression appended to a list
processors::Operations
number_listing_operations();  ///< an instruction with the number of a half-space appended to a list
processors::Operations field_search_operations();      ///< the place of the next number in packed bits
processors::Operations call_linking_operations();      ///< a call appended to a native program
processors::Operations call_operations();              ///< a call of a native program, and its return
processors::Operations pixel_loop_operations();        ///< an iteration of the loop over the pixels of a row
processors::Operations row_loop_operations();          ///< an iteration of the loop over rows
processors::Operations instruction_loop_operations();  ///< an iteration of the loop over instructions, with its opcode

}  // namespace csgsim::host
