// The only file that includes httplib.
#include "server.hpp"

#include <fmt/format.h>
#include <httplib.h>

#include <atomic>
#include <filesystem>
#include <memory>
#include <thread>

#include "crew.hpp"
#include "events.hpp"
#include "gate.hpp"

namespace strandline::serve {
namespace {

// Tabs and tools of one person; more is somebody trying.
constexpr std::size_t most_connections = 256;
constexpr int most_streams = 128;
constexpr std::chrono::seconds heartbeat(10);

class CrewQueue : public httplib::TaskQueue {
  public:
    void enqueue(std::function<void()> job) override { crew_.enqueue(std::move(job)); }
    void shutdown() override { crew_.shutdown(); }

  private:
    Crew crew_{most_connections};
};

Visitor visitor_of(const httplib::Request& request) {
    const auto header = [&](const char* name) { return request.get_header_value(name); };
    return {header("Host"), header("Origin"), header("Sec-Fetch-Site"), header("Authorization"),
            header("Cookie")};
}

Call call_of(const httplib::Request& request) {
    Call call{request.method, request.path, {}, {}, request.body};
    for (const auto& [key, value] : request.params) call.query.emplace(key, value);
    if (request.has_header("If-None-Match"))
        call.headers["if-none-match"] = request.get_header_value("If-None-Match");
    return call;
}

void give(httplib::Response& response, const Reply& reply) {
    response.status = reply.status;
    for (const auto& [name, value] : reply.headers) response.set_header(name, value);
    if (reply.status != 304) response.set_content(reply.body, reply.type);
}

/// One event stream: what holds now, then every event, until the page is closed.
class Stream {
  public:
    Stream(std::shared_ptr<Workspace> workspace, std::atomic<int>& count)
        : workspace_(std::move(workspace)), listener_(workspace_->hub().listen()), count_(count) {}
    Stream(const Stream&) = delete;
    Stream& operator=(const Stream&) = delete;
    ~Stream() { --count_; }

    bool go_on(httplib::DataSink& sink) {
        if (!begun_) {
            begun_ = true;
            return say(sink, wire_text(workspace_->standing_event()));
        }
        const auto event = listener_->next(heartbeat);
        if (event) return say(sink, wire_text(*event));
        if (listener_->closed()) {
            sink.done();
            return false;
        }
        return say(sink, ": still here\n\n");  // finds out whether anybody is
    }

  private:
    static bool say(httplib::DataSink& sink, const std::string& text) {
        return sink.write(text.data(), text.size());
    }
    std::shared_ptr<Workspace> workspace_;
    std::shared_ptr<Listener> listener_;
    std::atomic<int>& count_;
    bool begun_ = false;
};

class Pages {
  public:
    Pages(Api& api, const ServeOptions& options)
        : api_(api), options_(options), gate_{options.host, 0, options.token} {}

    Outcome<void> run(const std::function<void(int)>& listening, const std::function<void()>& ended) {
        set_up();
        const int port = options_.port > 0
                             ? (server_.bind_to_port(options_.host, options_.port) ? options_.port : -1)
                             : server_.bind_to_any_port(options_.host);
        if (port <= 0)
            return fail(fmt::format("{}:{}", options_.host, options_.port), "cannot be listened on",
                        "choose another --port, or --host 127.0.0.1");
        gate_.port = port;
        std::thread waiter([&] {
            ended();
            api_.close();
            server_.stop();
        });
        listening(port);
        server_.listen_after_bind();
        waiter.join();
        return {};
    }

  private:
    void set_up() {
        server_.new_task_queue = [] { return new CrewQueue; };
        server_.set_tcp_nodelay(true);
        server_.set_payload_max_length(largest_upload);
        server_.set_read_timeout(20);
        server_.set_write_timeout(20);
        server_.set_keep_alive_max_count(1'000'000);
        server_.set_default_headers(
            {{"X-Content-Type-Options", "nosniff"},
             {"Referrer-Policy", "no-referrer"},
             {"Cross-Origin-Resource-Policy", "same-origin"},
             {"Content-Security-Policy",
              "default-src 'self'; img-src 'self' data: blob:; style-src 'self' 'unsafe-inline'; "
              "frame-ancestors 'none'; base-uri 'none'; form-action 'none'"}});
        // Bodies are read before a POST is refused: what is left of one would be taken for the next request.
        server_.set_pre_routing_handler([this](const auto& request, auto& response) {
            const bool without_body = request.method == "GET" || request.method == "HEAD";
            return without_body && !let_in(request, response) ? httplib::Server::HandlerResponse::Handled
                                                              : httplib::Server::HandlerResponse::Unhandled;
        });
        server_.set_error_handler([](const httplib::Request& request, httplib::Response& response) {
            if (!response.body.empty()) return;
            const char* why = response.status == 413   ? "is larger than 64 MB"
                              : response.status == 404 ? "there is nothing here"
                                                       : "cannot be understood";
            give(response, refusal(response.status, {request.path, why, "see /openapi.json"}));
        });
        server_.set_exception_handler([](const auto& request, auto& response, std::exception_ptr) {
            give(response, refusal(500, {request.path, "failed", "report this with the project"}));
        });
        const auto answer = [this](const httplib::Request& request, httplib::Response& response) {
            if (let_in(request, response)) give(response, api_.answer(call_of(request)));
        };
        server_.Get(R"(/api/v1/projects/([^/]+)/events)",
                    [this](const auto& request, auto& response) { stream(request, response); });
        server_.Get("/api/.*", answer);
        server_.Post("/.*", answer);
        server_.Put("/.*", answer);
        server_.Patch("/.*", answer);
        server_.Delete("/.*", answer);
        // With a parameter they are not compressed: on one machine that costs more than it saves.
        server_.set_file_extension_and_mimetype_mapping("js", "application/javascript; charset=utf-8");
        if (!options_.web.empty()) server_.set_mount_point("/", options_.web);
        server_.set_file_request_handler([](const auto& request, auto& response) {
            const bool forever = request.path.starts_with("/assets/");  // named by their content
            response.set_header("Cache-Control", forever ? "max-age=31536000, immutable" : "no-cache");
        });
    }

    /// The token in the address becomes a cookie: it does not stay in the history.
    bool take_token(const httplib::Request& request, httplib::Response& response) const {
        if (gate_.token.empty() || request.path != "/" || !request.has_param("token")) return false;
        if (!is_token(gate_, request.get_param_value("token"))) return false;
        std::string rest = "/";
        for (const auto& [key, value] : request.params)
            if (key != "token") rest += fmt::format("{}{}={}", rest.size() == 1 ? "?" : "&", key, value);
        if (rest.find_first_of("\r\n") != std::string::npos) rest.resize(1);
        response.set_header(
            "Set-Cookie", fmt::format("{}={}; HttpOnly; SameSite=Strict; Path=/", token_cookie, gate_.token));
        response.set_redirect(rest, 303);
        return true;
    }

    bool let_in(const httplib::Request& request, httplib::Response& response) const {
        const Visitor visitor = visitor_of(request);
        if (const auto fine = from_here(gate_, visitor); !fine) {
            give(response, refusal(403, fine.error()));
            return false;
        }
        if (knows_token(gate_, visitor)) return true;
        if (!take_token(request, response))
            give(response,
                 refusal(401, {"token", "is missing or wrong", "open the address with ?token=..."}));
        return false;
    }

    void stream(const httplib::Request& request, httplib::Response& response) {
        auto workspace = api_.workspace(request.matches[1]);
        if (!workspace) return give(response, refusal(404, workspace.error()));
        if (++streams_ > most_streams) {
            --streams_;
            return give(response, refusal(503, {"events", "too many pages are open", "close some of them"}));
        }
        auto open = std::make_shared<Stream>(std::move(*workspace), streams_);
        response.set_header("Cache-Control", "no-store");
        response.set_chunked_content_provider(
            "text/event-stream", [open](std::size_t, httplib::DataSink& sink) { return open->go_on(sink); });
    }

    Api& api_;
    const ServeOptions options_;
    Gate gate_;
    std::atomic<int> streams_{0};
    httplib::Server server_;
};

}  // namespace

Outcome<void> serve(Api& api, const ServeOptions& options, const std::function<void(int)>& listening,
                    const std::function<void()>& ended) {
    if (!is_loopback(options.host) && options.token.empty())
        return fail("--host " + options.host, "lets others on the network in",
                    "protect it with --token SECRET");
    return Pages(api, options).run(listening, ended);
}

}  // namespace strandline::serve
