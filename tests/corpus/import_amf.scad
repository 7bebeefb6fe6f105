// An AMF file of two objects.
import("data/two_boxes.amf");
