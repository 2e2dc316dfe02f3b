// The API without sockets: calls in, replies out.
#include <gtest/gtest.h>

#include <chrono>
#include <cmath>
#include <fstream>
#include <nlohmann/json.hpp>
#include <thread>

#include "plan/pipeline/pipeline.hpp"
#include "projects.hpp"

namespace strandline::serve {
namespace {

using Json = nlohmann::json;

class ApiTest : public ::testing::Test {
  protected:
    Json ask(const std::string& method, const std::string& path, const std::string& body = "",
             int status = 200) {
        std::string where = path;
        Call call{method, "", {}, {}, body};
        if (const auto mark = where.find('?'); mark != std::string::npos) {
            const std::string query = where.substr(mark + 1);
            const auto equals = query.find('=');
            call.query[query.substr(0, equals)] = query.substr(equals + 1);
            where.resize(mark);
        }
        call.path = "/api/v1/" + where;
        const Reply reply = api.answer(call);
        EXPECT_EQ(reply.status, status) << method << ' ' << path << ": " << reply.body.substr(0, 300);
        Json json = Json::parse(reply.body, nullptr, false);
        EXPECT_FALSE(json.is_discarded()) << path;
        EXPECT_EQ(json.contains("error"), status >= 400) << path;
        return json;
    }
    std::string begin(const std::string& bytes = small_drawing) {
        return ask("POST", "projects?title=small.svg", bytes, 201)["id"];
    }
    Json settled(const std::string& id) {
        for (;;) {
            Json now = ask("GET", "projects/" + id);
            if (!now["planning"] && (!now["failure"].is_null() || now["plan"]["report"] != "")) return now;
            std::this_thread::sleep_for(std::chrono::milliseconds(5));
        }
    }
    std::string edit(int revision, const std::string& change) {
        return R"({"revision":)" + std::to_string(revision) + R"(,"what":"test","changes":[)" + change + "]}";
    }

    TempFolder folder;
    Api api{small_setup(), Folder(folder.path)};
};

TEST_F(ApiTest, ThePlanIsTheOneThatMakePlanMakes) {
    const std::string id = begin();
    settled(id);
    const std::string edits =
        R"({"edit":{"edit":"hint","element":"square","name":"fill-style","value":"zigzag"}},
        {"edit":{"edit":"order","elements":["ring","line","square"]}},{"set":"robot","value":"turf"},
        {"edit":{"edit":"draw","element":"pen1","paths":[["M",2,2,"L",5,3,"L",7,2]],"pins":1,"smooth":0.02}})";
    ask("POST", "projects/" + id + "/edits", edit(1, edits));
    EXPECT_TRUE(settled(id)["failure"].is_null());
    const auto made = api.workspace(id).value()->planned();
    const State state = api.workspace(id).value()->standing().state;
    auto fresh = make_plan(Source{small_drawing, "small.svg"}, state.robot, state.options, state.edits);
    ASSERT_TRUE(fresh);
    fresh->program = made->plan->program;
    EXPECT_EQ(*fresh, *made->plan);
    const Json drive = ask("GET", "projects/" + id + "/plan/drive");
    const Json drawing = ask("GET", "projects/" + id + "/plan/drawing");
    std::vector<std::string> order;
    for (const Json& stroke : drive["strokes"]) {
        const std::string name = drawing["elements"][stroke["element"].get<std::size_t>()]["id"];
        if (order.empty() || order.back() != name) order.push_back(name);
    }
    std::erase(order, "pen1");
    EXPECT_EQ(order, (std::vector<std::string>{"ring", "line", "square"}));
}

TEST_F(ApiTest, AStaleEditIsRefusedAndNothingIsLost) {
    const std::string id = begin();
    const std::string erase = R"({"edit":{"edit":"hint","element":"line","name":"ink","value":"off"}})";
    EXPECT_EQ(ask("POST", "projects/" + id + "/edits", edit(1, erase))["revision"], 2);
    EXPECT_EQ(ask("POST", "projects/" + id + "/edits", edit(1, erase), 409)["error"]["code"], "stale");
    ask("POST", "projects/" + id + "/undo", R"({"revision":1})", 409);
    EXPECT_EQ(ask("GET", "projects/" + id)["edits"].size(), 1u);
    EXPECT_EQ(ask("POST", "projects/" + id + "/undo", R"({"revision":2})")["revision"], 3);
    EXPECT_EQ(ask("POST", "projects/" + id + "/redo", R"({"revision":3})")["revision"], 4);
}

TEST_F(ApiTest, WhatIsNoEditIsRefusedWithItsPlace) {
    const std::string id = begin(), edits = "projects/" + id + "/edits";
    for (
        const char* body :
        {"", "x", "[]", "{}", R"({"revision":"1"})", R"({"revision":1,"what":"","changes":{}})",
         R"({"revision":1,"what":"","changes":[{"dig":1}]})",
         R"({"revision":1,"what":"","changes":[{"edit":{"edit":"jump"}}]})",
         R"({"revision":1,"what":"","changes":[{"edit":{"edit":"hint","element":"a","name":"no","value":"1"}}]})",
         R"({"revision":1,"what":"","changes":[{"edit":{"edit":"draw","element":"a","paths":[["M",1]],"pins":1,"smooth":0}}]})",
         R"({"revision":1,"what":"","changes":[{"source":0}]})"})
        ask("POST", edits, body, 400);
    ask("POST", edits, std::string(100'000, '['), 400);
    ask("POST", edits, std::string(largest_json + 1, ' '), 413);
    ask("POST", edits, edit(1, R"({"set":"fill.spacing","value":"-3"})"), 422);
    ask("POST", edits, edit(1, R"({"set":"robot","value":"unicorn"})"), 422);
    ask("POST", edits, edit(1, R"({"set":"corner.above","value":"pivot"})"), 422);
    EXPECT_EQ(ask("GET", "projects/" + id)["revision"], 1);
}

TEST_F(ApiTest, UnknownPlacesAreSaidToBeUnknown) {
    const std::string id = begin();
    settled(id);
    for (const std::string path : {"nothing", "projects/none", "projects/..", "projects/../../etc/passwd",
                                   "projects/%2e%2e", "projects//plan/drive", "about/x"})
        ask("GET", path, "", 404);
    for (const std::string path : {"/nothing", "/plan", "/plan/x", "/exports/exe", "/exports/../plan"})
        ask("GET", "projects/" + id + path, "", 404);
    ask("DELETE", "projects", "", 405);
    ask("DELETE", "projects/" + id + "/edits", "", 405);
    ask("GET", "projects/" + id + "/edits", "", 405);
    ask("PUT", "about", "", 405);
}

TEST_F(ApiTest, OnlyDrawingsAndProjectsAreTaken) {
    ask("POST", "projects?title=x", "MZ no drawing at all", 415);
    ask("POST", "projects?title=x", R"({"format":"other"})", 415);
    const std::string id = begin();
    const std::string copy =
        ask("POST", "projects?title=copy", api.workspace(id).value()->file_text(), 201)["id"];
    EXPECT_NE(copy, id);
    EXPECT_EQ(ask("GET", "projects")["projects"].size(), 2u);
}

TEST_F(ApiTest, WhatIsBrokenOrDrawsNothingBecomesNoProject) {
    const std::string bare = R"(<svg xmlns="http://www.w3.org/2000/svg"><g/></svg>)";
    const Json broken = ask("POST", "projects?title=eye.svg", R"(<svg><path d="M0)", 415)["error"];
    EXPECT_EQ(broken["place"].get<std::string>().substr(0, 15), "eye.svg, line 1");
    EXPECT_NE(broken["reason"].get<std::string>().find("not well-formed XML"), std::string::npos);
    EXPECT_NE(
        ask("POST", "projects?title=x", bare, 415)["error"]["reason"].get<std::string>().find("no shapes"),
        std::string::npos);
    ask("POST", "projects?title=x.png", "\x89PNG\r\n\x1a\nabc", 415);
    EXPECT_TRUE(ask("GET", "projects")["projects"].empty());
    const std::string id = begin();
    ask("POST", "projects/" + id + "/source?revision=1", bare, 415);
    EXPECT_EQ(ask("GET", "projects/" + id)["revision"], 1);
}

TEST_F(ApiTest, ADeletedProjectIsGoneForEverybody) {
    const std::string id = begin(), other = begin();
    const auto workspace = api.workspace(id).value();  // as a page has it open
    const auto listener = workspace->hub().listen();
    EXPECT_EQ(ask("DELETE", "projects/" + id)["id"], id);
    EXPECT_TRUE(listener->closed());
    ask("GET", "projects/" + id, "", 404);
    ask("DELETE", "projects/" + id, "", 404);
    const auto late = workspace->change(1, [](Project& project) {
        return take_step(project, {"late", {EditChange{HintEdit{"line", "pins", "1"}}}});
    });
    ASSERT_FALSE(late);
    EXPECT_EQ(late.error().place, "project");
    EXPECT_EQ(ask("GET", "projects")["projects"], Json::parse(R"([{"id":")" + other + "\"}]"));
    std::ofstream(folder.path / "spoilt.strandline") << "{";
    ask("GET", "projects/spoilt", "", 500);
    ask("DELETE", "projects/spoilt");
    TempFolder outside;
    std::ofstream(outside.path / "secret.strandline") << "{}";
    std::filesystem::create_symlink(outside.path / "secret.strandline", folder.path / "secret.strandline");
    for (const std::string& strange :
         {std::string("secret"), std::string(".."), "../" + outside.path.filename().string() + "/secret"})
        ask("DELETE", "projects/" + strange, "", 404);
    EXPECT_TRUE(std::filesystem::exists(outside.path / "secret.strandline"));
}

TEST_F(ApiTest, BareSandIsNoPlanUntilSomethingIsDrawn) {
    const std::string id = begin("");
    EXPECT_FALSE(settled(id)["failure"].is_null());
    EXPECT_TRUE(settled(id)["bare"]);
    const std::string line =
        R"({"edit":{"edit":"draw","element":"pen1","paths":[["M",2,2,"L",9,3]],"pins":3,"smooth":0}})";
    ask("POST", "projects/" + id + "/edits", edit(1, line));
    EXPECT_TRUE(settled(id)["failure"].is_null());
    EXPECT_EQ(ask("GET", "projects/" + id + "/plan/drawing")["elements"][0]["id"], "pen1");
    EXPECT_FALSE(settled(id)["bare"]);
    ask("POST", "projects/" + id + "/undo", R"({"revision":2})");
    EXPECT_FALSE(settled(id)["failure"].is_null());
    EXPECT_TRUE(settled(id)["bare"]);
    EXPECT_TRUE(settled(id)["plan"].is_null());  // the line that was undone is not shown any more
}

TEST_F(ApiTest, KeepOutsAndTheBorderAreSetAndShown) {
    const std::string id = begin();
    settled(id);
    const std::string edits = "projects/" + id + "/edits", drawing = "projects/" + id + "/plan/drawing";
    EXPECT_EQ(ask("GET", drawing)["keep_out"], Json::array());
    EXPECT_EQ(ask("GET", drawing)["border"].size(), 8u);
    ask("POST", edits, edit(1, R"({"set":"field.keep_out","value":"0,0 1,0 1,1; 5,5 6,5 6,6 5,6"})"));
    ask("POST", edits, edit(2, R"({"set":"field.border","value":"-3,-3 20,-3 20,20"})"));
    EXPECT_TRUE(settled(id)["failure"].is_null());
    EXPECT_EQ(ask("GET", drawing)["keep_out"], Json::parse("[[[0,0,1,0,1,1]],[[5,5,6,5,6,6,5,6]]]"));
    EXPECT_EQ(ask("GET", drawing)["border"], Json::parse("[-3,-3,20,-3,20,20]"));
    ask("POST", edits, edit(3, R"({"set":"field.keep_out","value":"0,0 1,0"})"), 422);
    ask("POST", edits, edit(3, R"({"set":"park.exit","value":"parked"})"), 422);
    ask("POST", edits, edit(3, R"({"set":"park.x","value":"1"})"));
    EXPECT_TRUE(settled(id)["failure"].is_null());
}

TEST_F(ApiTest, APartThatIsKnownIsNotSentAgain) {
    const std::string id = begin();
    const Json before = settled(id)["plan"];
    ask("POST", "projects/" + id + "/edits",
        edit(1, R"({"edit":{"edit":"direction","element":"line","direction":"backward"}})"));
    const Json after = settled(id)["plan"];
    EXPECT_EQ(after["drawing"], before["drawing"]);
    Call call{"GET",
              "/api/v1/projects/" + id + "/plan/drawing",
              {},
              {{"if-none-match", "\"" + before["drawing"].get<std::string>() + "\""}},
              ""};
    EXPECT_EQ(api.answer(call).status, 304);
    call.headers.clear();
    EXPECT_EQ(api.answer(call).status, 200);
}

TEST_F(ApiTest, ALinkOutOfTheFolderIsNotFollowed) {
    TempFolder outside;
    std::ofstream(outside.path / "secret.strandline") << "{}";
    std::filesystem::create_symlink(outside.path / "secret.strandline", folder.path / "secret.strandline");
    ask("GET", "projects/secret", "", 404);
    EXPECT_TRUE(ask("GET", "projects")["projects"].empty());
}

TEST_F(ApiTest, AConnectionIsTriedWithoutChangingAnything) {
    const std::string id = begin();
    settled(id);
    const std::string path = "projects/" + id + "/connection";
    const auto wish = [](const std::string& plan, const std::string& connection, const std::string& through) {
        return R"({"plan":)" + plan + R"(,"connection":)" + connection + R"(,"through":)" + through + "}";
    };
    const Json plain = ask("POST", path, wish("1", "0", "[]"));
    const Json led = ask("POST", path, wish("1", "0", "[[7,3,0.5]]"));
    EXPECT_GT(led["length"], plain["length"]);
    double nearest = 1;
    for (std::size_t i = 0; i < led["points"].size(); i += 2)
        nearest = std::min(
            nearest, std::hypot(led["points"][i].get<double>() - 7, led["points"][i + 1].get<double>() - 3));
    EXPECT_LT(nearest, 0.1);
    ask("POST", path, wish("2", "0", "[]"), 409);
    ask("POST", path, wish("1", "99", "[]"), 422);
    for (const char* wrong : {"7", "[[1,2]]", "[[1,2,\"x\"]]", "[[1,2,null]]"})
        ask("POST", path, wish("1", "0", wrong), 400);
    ask("POST", path, wish("1", "0", "[[1e300,0,0]]"), 422);
    ask("POST", path, "[", 400);
    ask("POST", path, R"({"plan":1e99,"connection":-5,"through":[]})", 400);
    ask("GET", path, "", 405);
    EXPECT_EQ(ask("GET", "projects/" + id)["revision"], 1);
}

TEST_F(ApiTest, WhatIsToldLastIsWhatHolds) {
    const std::string id = begin();
    const auto workspace = api.workspace(id).value();
    const auto listener = workspace->hub().listen();
    const auto edit_many = [&] {
        for (int i = 0; i < 60; ++i)
            static_cast<void>(workspace->change(workspace->standing().revision, [&](Project& project) {
                return take_step(project, {"", {EditChange{HintEdit{"line", "pins", "1"}}}});
            }));
    };
    std::thread other(edit_many);
    edit_many();
    other.join();
    settled(id);
    long long news = 0;
    std::string last;
    while (const auto event = listener->next(std::chrono::milliseconds(100))) {
        if (event->name != "standing") continue;
        const long long here = Json::parse(event->data)["news"];
        EXPECT_GE(here, news);
        news = here;
        last = event->data;
    }
    EXPECT_EQ(last, workspace->standing_event().data);
    EXPECT_EQ(ask("GET", "projects/" + id)["news"], news);
}

TEST_F(ApiTest, ManyEditsInARowEndWithThePlanOfTheLast) {
    const std::string id = begin();
    for (int i = 1; i <= 40; ++i)
        ask("POST", "projects/" + id + "/edits",
            edit(i, std::string(R"({"edit":{"edit":"direction","element":"line","direction":")") +
                        (i % 2 ? "forward" : "backward") + "\"}}"));
    const Json now = settled(id);
    EXPECT_EQ(now["plan"]["revision"], 41);
    EXPECT_EQ(now["undo"]["count"], 40);
}

}  // namespace
}  // namespace strandline::serve
