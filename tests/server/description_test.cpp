// web/public/openapi.json describes what the server answers.
#include <gtest/gtest.h>

#include <fstream>
#include <nlohmann/json.hpp>

#include "projects.hpp"

namespace strandline::serve {
namespace {

using Json = nlohmann::json;

void replace(std::string& text, const std::string& what, const std::string& with) {
    if (const std::size_t at = text.find(what); at != std::string::npos) text.replace(at, what.size(), with);
}

TEST(Description, EveryRouteAnswersAsDescribedAndTakesNoOtherMethod) {
    const TempFolder folder;
    Api api{small_setup(), Folder(folder.path)};
    std::ifstream file(STRANDLINE_SOURCE "/web/public/openapi.json");
    const Json description = Json::parse(file);
    int routes = 0;
    for (const auto& [path, methods] : description["paths"].items()) {
        if (path.ends_with("/events")) continue;  // a stream: answered a floor higher, see http_test
        std::string where = path;
        const std::string id = *api.create("small.svg", small_drawing);  // one of the routes deletes it
        replace(where, "{id}", id);
        replace(where, "{format}", "plan");
        for (const auto& [method, name] : {std::pair("GET", "get"), std::pair("POST", "post"),
                                           std::pair("PUT", "put"), std::pair("DELETE", "delete")}) {
            const Reply reply = api.answer({method, where, {}, {}, ""});
            SCOPED_TRACE(std::string(method) + " " + path + ": " + reply.body.substr(0, 200));
            if (!methods.contains(name)) {
                EXPECT_EQ(reply.status, 405);
                continue;
            }
            ++routes;
            EXPECT_TRUE(methods[name]["responses"].contains(std::to_string(reply.status))) << reply.status;
            EXPECT_EQ(reply.body.find("there is nothing here"), std::string::npos);
        }
    }
    EXPECT_GT(routes, 12);
    const std::string id = *api.create("small.svg", small_drawing);
    EXPECT_EQ(api.answer({"GET", "/api/v1/projects/" + id + "/plan/nothing", {}, {}, ""}).status, 404);
}

}  // namespace
}  // namespace strandline::serve
