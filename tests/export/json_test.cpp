#include "export/json.h"

#include <doctest/doctest.h>
#include <limits>

namespace json_test {

using namespace multipath;

TEST_CASE("a JSON document escapes text, keeps numbers exact and says null for what is not a number")
{
    JsonObject inner;
    inner.count("n", 18446744073709551615ull);
    JsonObject json;
    json.text("name", "a \"b\" \\ \n\t");
    json.number("third", 1.0 / 3.0);
    json.number("tenth", 0.1);
    json.number("nothing", std::numeric_limits<double>::quiet_NaN());
    json.boolean("yes", true);
    json.null("none");
    json.numbers("list", {1, 2.5});
    json.object("object", inner);
    json.objects("objects", {inner});
    CHECK(json.document() ==
          "{\n  \"name\": \"a \\\"b\\\" \\\\ \\u000a\\u0009\",\n"
          "  \"third\": 0.3333333333333333,\n  \"tenth\": 0.1,\n  \"nothing\": null,\n  \"yes\": true,\n"
          "  \"none\": null,\n  \"list\": [1, 2.5],\n  \"object\": {\"n\": 18446744073709551615},\n  \"objects\": [\n  "
          "  {\"n\": 18446744073709551615}]\n}\n");
}

TEST_CASE("bytes that are no UTF-8 do not make a document that nobody reads")
{
    JsonObject json;
    json.text("na\xefve", "caf\xe9");
    CHECK(json.document() == "{\n  \"na\xc3\xafve\": \"caf\xc3\xa9\"\n}\n");
}

} // namespace json_test
