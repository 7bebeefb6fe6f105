  pixel_planes #(
@PARAMETERS@
  ) machine (
    .clk(clk), .reset(reset), .frame(frame), .request(request), .request_from(request_from), .word(word),
    .word_valid(word_valid), .word_ready(word_ready), .told(told), .told_any(told_any), .done(done), .clocks(clocks),
    .video_valid(video_valid), .video_row(video_row), .video_frame(video_frame), .video(video), .shown(shown));
