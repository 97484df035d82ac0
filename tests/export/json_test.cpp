#include "export/json.h"

#include <doctest/doctest.h>

#include <limits>
#include <string>

namespace json_test {

using namespace multipath;

namespace {

/// A text as a document holds it.
std::string in_json(const std::string& text)
{
    JsonObject json;
    json.text("text", text);
    return json.document();
}

std::string quoted(const std::string& text)
{
    return "{\n  \"text\": \"" + text + "\"\n}\n";
}

} // namespace

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
    json.numbers("list", std::vector<double>{1, 2.5});
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

TEST_CASE("UTF-8 stays as it is")
{
    for (const char* text :
         {"", "plain", "caf\xc3\xa9", "\xe2\x82\xac", "\xf0\x9f\x92\xa1", "\xf4\x8f\xbf\xbf", "\x7f"})
        CHECK(in_json(text) == quoted(text));
}

// RFC 3629, sections 3 and 10: bytes alone, sequences cut short, longer than needed, halves of pairs, beyond U+10FFFF.
TEST_CASE("other bytes become the Latin-1 characters of their values")
{
    CHECK(in_json("caf\xe9 au lait") == quoted("caf\xc3\xa9 au lait"));
    CHECK(in_json("\x80") == quoted("\xc2\x80"));
    CHECK(in_json("\xc3") == quoted("\xc3\x83"));
    CHECK(in_json("\xc3 ") == quoted("\xc3\x83 "));
    CHECK(in_json("\xc0\xaf") == quoted("\xc3\x80\xc2\xaf"));
    CHECK(in_json("\xe0\x9f\xbf") == quoted("\xc3\xa0\xc2\x9f\xc2\xbf"));
    CHECK(in_json("\xed\xa0\x80") == quoted("\xc3\xad\xc2\xa0\xc2\x80"));
    CHECK(in_json("\xf4\x90\x80\x80") == quoted("\xc3\xb4\xc2\x90\xc2\x80\xc2\x80"));
    CHECK(in_json("\xff") == quoted("\xc3\xbf"));
}

} // namespace json_test
