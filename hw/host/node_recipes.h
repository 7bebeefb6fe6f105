// Processor operations per task of a processor that divides a model and draws it at pixels.
// Used by hw/multi_processor and tests.
#pragma once

#include "hw/processors/operations.h"

// Operations of the nodes and the display processor of a multi-processor, assumed like those of the host. Tasks that
// the host also performs have the host's recipes (hw/host/recipes.h).
namespace csgsim::host {

/// Transformation of a plane of the model: the host's `quotients` and `planes`, and 12 products that the host looks up
/// in tables and a node computes.
processors::Operations plane_transform_operations();

/// Test of a primitive's box against a part of the picture: the host's `boxes`.
processors::Operations box_test_operations();

/// Test of a half-space at the corners of a part of the picture: the host's `tests`.
processors::Operations halfspace_test_operations();

/// Comparison of a half-space with the leaders of a cell (hw/division/cells.h).
processors::Operations cell_test_operations();

/// Visit of a node of the tree, with a test of its box: the host's `nodes` and `boxes`.
processors::Operations node_visit_operations();

/// Appending an instruction with its expression to a list.
processors::Operations instruction_listing_operations();

/// Appending an instruction with the number of a half-space to a list.
processors::Operations number_listing_operations();

/// Computing the position of the next number in packed bits.
processors::Operations field_search_operations();

/// A call appended to a native program.
processors::Operations call_linking_operations();

/// A call in a native program, and its return.
processors::Operations call_operations();

/// An iteration of the loop over the pixels of a row.
processors::Operations pixel_loop_operations();

/// An iteration of the loop over rows.
processors::Operations row_loop_operations();

/// An iteration of the loop over instructions, with the dispatch on the opcode.
processors::Operations instruction_loop_operations();

}  // namespace csgsim::host
