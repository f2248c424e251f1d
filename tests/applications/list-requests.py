#!/usr/bin/env python3
"""Prints the port of a server on this machine that has no files, then the path of each request, until one for /last."""
import http.server


class Handler(http.server.BaseHTTPRequestHandler):
    def do_GET(self):
        print(self.path, flush=True)
        self.send_error(404)
        self.server.is_ended = self.path == "/last"

    def log_message(self, *arguments):
        pass


with http.server.HTTPServer(("127.0.0.1", 0), Handler) as server:
    server.is_ended = False
    print(server.server_port, flush=True)
    while not server.is_ended:
        server.handle_request()
