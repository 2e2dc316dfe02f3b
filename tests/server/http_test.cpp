// The program itself, over the loopback: streams, limits, strangers, and being ended at any moment.
#include <gtest/gtest.h>
#include <httplib.h>
#include <signal.h>
#include <sys/wait.h>
#include <unistd.h>

#include <atomic>
#include <fstream>
#include <nlohmann/json.hpp>
#include <random>
#include <thread>

#include "projects.hpp"

namespace strandline::serve {
namespace {

using Json = nlohmann::json;

/// strandline serve, ended with the test.
class Served {
  public:
    explicit Served(const std::filesystem::path& folder, std::vector<std::string> more = {}) {
        int pipe_ends[2];
        if (pipe(pipe_ends) != 0) std::abort();
        child_ = fork();
        if (child_ == 0) {
            dup2(pipe_ends[1], STDOUT_FILENO);
            close(pipe_ends[0]);
            std::vector<std::string> words{STRANDLINE_PROGRAM, "serve", (folder / "small.svg").string(),
                                           "--port", "0"};
            words.insert(words.end(), more.begin(), more.end());
            std::vector<char*> arguments;
            for (std::string& word : words) arguments.push_back(word.data());
            arguments.push_back(nullptr);
            execv(STRANDLINE_PROGRAM, arguments.data());
            _exit(127);
        }
        close(pipe_ends[1]);
        std::string line;
        char c = 0;
        while (read(pipe_ends[0], &c, 1) == 1 && c != '\n') line += c;
        close(pipe_ends[0]);
        const auto colon = line.find(':', 5);
        port = colon == std::string::npos ? 0 : std::atoi(line.c_str() + colon + 1);
    }
    Served(const Served&) = delete;
    Served& operator=(const Served&) = delete;
    ~Served() { end(SIGTERM); }
    int end(int how) {
        if (child_ <= 0) return 0;
        kill(child_, how);
        int status = 0;
        waitpid(child_, &status, 0);
        child_ = 0;
        return status;
    }
    httplib::Client client() const {
        httplib::Client c("127.0.0.1", port);
        c.set_read_timeout(30);
        c.set_keep_alive(true);
        c.set_tcp_nodelay(true);
        return c;
    }
    int port = 0;

  private:
    pid_t child_ = 0;
};

std::filesystem::path put_drawing(const TempFolder& folder) {
    std::ofstream(folder.path / "small.svg") << small_drawing;
    return folder.path;
}
std::string erase(long long revision, const std::string& id) {
    return Json{
        {"revision", revision},
        {"what", "erase " + id},
        {"changes", {{{"edit", {{"edit", "hint"}, {"element", id}, {"name", "ink"}, {"value", "off"}}}}}}}
        .dump();
}
constexpr const char* project = "/api/v1/projects/small";
const std::string edits = std::string(project) + "/edits";

TEST(Http, FiftyPagesWithStreamsHoldUpNobodyAndAllHearOfAnEdit) {
    TempFolder folder;
    const Served served(put_drawing(folder));
    ASSERT_GT(served.port, 0);
    constexpr int pages = 50;
    std::atomic<int> begun{0}, heard{0};
    std::vector<std::thread> streams;
    for (int i = 0; i < pages; ++i)
        streams.emplace_back([&] {
            httplib::Client c = served.client();
            std::string text;
            bool first = true;
            c.Get(std::string(project) + "/events", [&](const char* data, std::size_t size) {
                text.append(data, size);
                if (first && text.find("standing") != std::string::npos) {
                    first = false;
                    ++begun;
                }
                if (text.find("\"revision\":2,") == std::string::npos) return true;
                ++heard;
                return false;
            });
        });
    while (begun < pages) std::this_thread::sleep_for(std::chrono::milliseconds(5));
    httplib::Client c = served.client();
    const auto reply = c.Post(edits, erase(1, "line"), "application/json");
    ASSERT_TRUE(reply);
    EXPECT_EQ(reply->status, 200);
    for (std::thread& stream : streams) stream.join();
    EXPECT_EQ(heard, pages);
}

TEST(Http, StrangersAndNonsenseGetAClearErrorAndChangeNothing) {
    TempFolder folder;
    const Served served(put_drawing(folder));
    httplib::Client c = served.client();
    const auto expect = [&](const httplib::Result& reply, int status) {
        ASSERT_TRUE(reply);
        EXPECT_EQ(reply->status, status) << reply->body;
        const Json json = Json::parse(reply->body, nullptr, false);
        ASSERT_FALSE(json.is_discarded()) << reply->body;
        EXPECT_FALSE(json["error"]["reason"].get<std::string>().empty());
    };
    expect(c.Get(project, {{"Host", "evil.example"}}), 403);
    expect(c.Post(edits, {{"Origin", "http://evil.example"}}, erase(1, "line"), "application/json"), 403);
    expect(c.Post(edits, {{"Origin", "null"}}, erase(1, "line"), "text/plain"), 403);
    expect(c.Delete(project, {{"Origin", "http://evil.example"}}), 403);
    expect(c.Delete(project, {{"Host", "evil.example"}}), 403);
    expect(c.Post(edits, {{"Sec-Fetch-Site", "cross-site"}}, erase(1, "line"), "application/json"), 403);
    expect(c.Get(std::string(project) + "/events", {{"Host", "evil.example"}}), 403);
    expect(c.Get("/api/v1/projects/none/events"), 404);
    expect(c.Post(edits, "{", "application/json"), 400);
    expect(c.Get("/api/v1/projects/..%2f..%2fetc%2fpasswd"), 404);
    expect(c.Get("/../../etc/passwd"), 404);
    expect(c.Get("/%2e%2e/%2e%2e/etc/passwd"), 404);
    expect(c.Post(edits, std::string(largest_json + 1, ' '), "application/json"), 413);
    {
        httplib::Client big = served.client();
        const auto reply =
            big.Post("/api/v1/projects", std::string(largest_upload + 1, ' '), "application/octet-stream");
        // or the connection was closed on what was still being sent
        EXPECT_EQ(reply ? reply->status : 413, 413);
    }
    const auto now = served.client().Get(project);
    ASSERT_TRUE(now);
    EXPECT_EQ(Json::parse(now->body)["revision"], 1);
}

TEST(Http, OthersOnTheNetworkNeedTheToken) {
    TempFolder folder;
    const Served refused(put_drawing(folder), {"--host", "0.0.0.0"});
    EXPECT_EQ(refused.port, 0);
    const Served served(folder.path, {"--host", "0.0.0.0", "--token", "sand"});
    ASSERT_GT(served.port, 0);
    httplib::Client c = served.client();
    EXPECT_EQ(c.Get(project)->status, 401);
    EXPECT_EQ(c.Get(project, {{"Authorization", "Bearer sandy"}})->status, 401);
    EXPECT_EQ(c.Get(project, {{"Authorization", "Bearer sand"}})->status, 200);
    const auto taken = c.Get("/?token=sand&project=small");
    EXPECT_EQ(taken->status, 303);
    EXPECT_EQ(taken->get_header_value("Location"), "/?project=small");
    EXPECT_EQ(taken->get_header_value("Set-Cookie").find("strandline_token=sand; HttpOnly"), 0u);
    EXPECT_EQ(c.Get("/?token=wrong")->status, 401);
}

TEST(Http, EndedAtAnyMomentItLosesAtMostTheEditInFlight) {
    TempFolder folder;
    put_drawing(folder);
    std::mt19937 random(7);
    long long answered = 1;  // revision that the server has said is kept
    for (int round = 0; round < 50; ++round) {
        Served served(folder.path);
        ASSERT_GT(served.port, 0) << "round " << round;
        const auto now = served.client().Get(project);
        ASSERT_TRUE(now);
        const Json standing = Json::parse(now->body);
        const long long found = standing["revision"];
        ASSERT_GE(found, answered) << "round " << round;
        ASSERT_LE(found, answered + 1) << "round " << round;
        ASSERT_EQ(standing["undo"]["count"].get<long long>(), found - 1);
        answered = found;
        std::atomic<bool> go{round % 2 == 0};  // else: when an edit is answered, however slow the machine is
        std::thread killer([&served, &go, wait = random() % 40] {
            go.wait(false);
            std::this_thread::sleep_for(std::chrono::milliseconds(wait));
            served.end(SIGKILL);
        });
        httplib::Client c = served.client();
        for (;;) {
            const auto reply =
                c.Post(edits, erase(answered, "e" + std::to_string(answered)), "application/json");
            go = true;
            go.notify_one();
            if (!reply || reply->status != 200) break;
            answered = Json::parse(reply->body)["revision"];
        }
        killer.join();
    }
    EXPECT_GT(answered, 25);  // edits were in flight
}

}  // namespace
}  // namespace strandline::serve
