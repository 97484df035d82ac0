#include "viewer/story_json.h"

#include "scene/scene.h"

#include <doctest/doctest.h>

namespace story_json_test {

using namespace multipath;

TEST_CASE("a told line becomes a chain of points with the power along it")
{
    ViewerLine line;
    line.shape = {"line 1", {{{0, 0, 0}, {1, 0, 0}, false}, {{1, 0, 0}, {1.0 / 3.0, 2, 3e-9}, true}}, {{1, 0, 0}}};
    line.transfers = {{1, 7, 9, {0.5, 0.5, 0.5}, {1, 2, 3}, {1.5, 2.5, 3.5}},
                      {1, 9, Scene::no_patch, {}, {4, 4, 4}, {4, 4, 4}}};
    CHECK(story_json({"Lines", "All \"two\".", {line}}).document() ==
          "{\n  \"title\": \"Lines\",\n  \"note\": \"All \\\"two\\\".\",\n  \"lines\": [\n    {\"label\": \"line 1\", "
          "\"points\": [0, 0, 0, 1, 0, 0, 0.333333, 2, 3e-09], \"bold\": \"01\", \"meetings\": [1, 0, 0], "
          "\"transfers\": [\n    {\"stretch\": 1, \"from\": 7, \"to\": 9, \"forecast\": [0.5], \"held\": [1, 2, 3], "
          "\"counted\": [1.5, 2.5, 3.5]}, \n    {\"stretch\": 1, \"from\": 9, \"to\": null, \"forecast\": [0], "
          "\"held\": [4], \"counted\": [4]}]}]\n}\n");
}

} // namespace story_json_test
