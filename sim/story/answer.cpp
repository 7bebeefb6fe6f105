#include "sim/story/answer.h"

#include "sim/story/story.h"
#include "sim/story/story_json.h"
#include "sim/story/story_text.h"
#include "sim/story/why_not.h"

namespace csgsim::story {

PixelExplanation explain_pixel(const Subject& subject, const machines::Machine& machine, std::uint32_t x,
                               std::uint32_t y, std::optional<std::uint32_t> missing) {
  const Story story = StoryBuilder(subject.program, machine).story_of(x, y);
  PixelExplanation answer{text_of(subject, story), to_json(subject, story)};
  if (!missing) return answer;
  const WhyNot why = why_not(subject, story, *missing);
  answer.text = text_of(subject, story, why) + "\n" + answer.text;
  answer.json["why_not"] = to_json(subject, story, why);
  return answer;
}

}  // namespace csgsim::story
