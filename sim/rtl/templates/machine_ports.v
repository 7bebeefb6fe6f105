  output wire told,
  output wire told_any,
  output wire done,
  output wire [31:0] clocks,
  output wire video_valid,
  output wire video_row,
  output wire video_frame,
  output wire [@VIDEO_WIRES@-1:0] video,
  output wire shown
