"""Examples on the network, asked by real clients."""
import re
import shutil
import socket
import subprocess
import threading
import urllib.error
import urllib.request

from example import PATIENCE_S, Running, free_port

# Virtual seconds per second: a question takes frames of 8 ms.
RATE = "10"


def receive_all(client, size):
    data = b""
    while len(data) < size:
        piece = client.recv(size - len(data))
        if not piece:
            break
        data += piece
    return data


def check_EchoServer(example):
    port = example.use_free_port("EchoServer/EchoServer.h", 7000)
    example.build()
    with Running(example, rate=RATE) as robot:
        first, second = robot.connect(port), robot.connect(port)
        for client, text in ((second, b"two"), (first, b"hello\n"), (second, b"more")):
            client.sendall(text)
            example.expect(receive_all(client, len(text)) == text, f"{text} does not come back")
        second.close()
        robot.wait_for("1: closed after 7 bytes")

        # The place is free again; much data, in whatever pieces.
        third = robot.connect(port)
        much = bytes(i * 7 % 251 for i in range(30000))
        threading.Thread(target=third.sendall, args=(much,)).start()
        example.expect(receive_all(third, len(much)) == much, "30000 bytes come back changed")
        third.shutdown(socket.SHUT_WR)
        example.expect(third.recv(1) == b"", "the server does not end the connection")
        first.close()
        robot.wait_for("closed after", 3)
        outcome = robot.press_pause()
    wanted = [f"EchoServer: listening on TCP port {port}"]
    for index, count in ((0, 6), (1, 7), (1, 30000)):
        wanted += [f"EchoServer: {index}: connected with 127.0.0.1",
                   f"EchoServer: {index}: closed after {count} bytes"]
    example.expect_lines(sorted(outcome.lines), sorted(wanted))
    readme = example.readme_block(1) + example.readme_block(2)
    example.expect(readme == [wanted[0].replace(str(port), "7000")] + wanted[1:3],
                   f"README.md says otherwise: {readme}")


def echo_in_pieces(listener):
    """Serves one client; every byte goes back on its own."""
    client, _ = listener.accept()
    client.setsockopt(socket.IPPROTO_TCP, socket.TCP_NODELAY, 1)
    with client:
        while data := client.recv(1000):
            for byte in data:
                client.sendall(bytes([byte]))


def check_EchoClient(example):
    example.build()
    with socket.create_server(("127.0.0.1", 0)) as listener:
        port = listener.getsockname()[1]
        example.replace("MS/OPEN-R/MW/CONF/ECHO.CFG", "127.0.0.1 7000", f"127.0.0.1 {port}\r")
        server = threading.Thread(target=echo_in_pieces, args=(listener,), daemon=True)
        server.start()
        with Running(example, rate=RATE) as robot:
            robot.wait_for("closed")
            outcome = robot.press_pause()
        example.expect_lines(outcome.lines, example.readme_block(1))
        server.join(PATIENCE_S)

    example.replace("MS/OPEN-R/MW/CONF/ECHO.CFG", str(port), str(free_port()))
    with Running(example, rate=RATE) as robot:
        robot.wait_for("closed")
        outcome = robot.press_pause()
    example.expect_lines(outcome.lines, example.readme_block(2))


def ask_udp(client, port, datagram):
    """Asks again as long as nobody answers: the robot binds at one of its next frames."""
    client.settimeout(1)
    for _ in range(PATIENCE_S):
        client.sendto(datagram, ("127.0.0.1", port))
        try:
            return client.recv(65536)
        except (TimeoutError, ConnectionRefusedError):
            pass
    return None


def check_UdpEcho(example):
    port = example.use_free_port("UdpEcho/UdpEcho.h", 7001, socket.SOCK_DGRAM)
    example.build()
    with Running(example, rate=RATE) as robot:
        robot.wait_for("listening")
        with socket.socket(socket.AF_INET, socket.SOCK_DGRAM) as client:
            for datagram in (b"hello\n", bytes(range(256)) * 16):
                answer = ask_udp(client, port, datagram)
                example.expect(answer == datagram, f"{len(datagram)} bytes do not come back")
        outcome = robot.press_pause()
    for wanted in example.readme_block(1) + example.readme_block(2):
        wanted = wanted.replace("7001", str(port))
        example.expect(wanted in outcome.lines, f"not printed: '{wanted}'")
    example.expect("UdpEcho: 4096 bytes from 127.0.0.1" in outcome.lines, outcome.lines)


def fetch(port, path, data=None):
    """Status and body; with curl where it is installed."""
    url = f"http://127.0.0.1:{port}{path}"
    if data is None and shutil.which("curl"):
        done = subprocess.run(["curl", "-sS", "--noproxy", "*", "-w", "\n%{http_code}", url],
                              capture_output=True, text=True, timeout=PATIENCE_S)
        body, _, status = done.stdout.rpartition("\n")
        return int(status or 0), body
    opener = urllib.request.build_opener(urllib.request.ProxyHandler({}))
    try:
        with opener.open(url, data, timeout=PATIENCE_S) as answer:
            return answer.status, answer.read().decode()
    except urllib.error.HTTPError as error:
        return error.code, error.read().decode()


def check_HttpServer(example):
    port = example.use_free_port("HttpServer/HttpServer.h", 8080)
    example.build()
    with Running(example, rate=RATE) as robot:
        # In three pieces, with the frame after which sensors are known.
        with robot.connect(port) as client:
            robot.wait_for("http on")
            for piece in (b"GET /joi", b"nts HTTP/1.0\r\nHost: dog\r", b"\n\r\n"):
                client.sendall(piece)
            answer = receive_all(client, 100000).decode()
        example.expect(answer.startswith("HTTP/1.0 200 OK\r\n") and "frame " in answer, answer)

        status, text = fetch(port, "/joints")
        angles = dict(re.findall(r"^([a-z0-9 ]+): (-?\d+\.\d)$", text, re.M))
        example.expect(status == 200 and len(angles) == 18, f"{status}: {text}")
        status, page = fetch(port, "/")
        example.expect(status == 200 and page.endswith("</html>\n"), f"{status}: {page}")
        example.expect(page.count("<tr>") == 18, page)
        example.expect(fetch(port, "/nothing")[0] == 404, "no 404 for what is not there")
        example.expect(fetch(port, "/", b"data")[0] == 501, "no 501 for POST")
        outcome = robot.press_pause()
    example.expect_lines(outcome.lines,
                         [line.replace("8080", str(port)) for line in example.readme_block(1)])
    joints = outcome.report["robots"][0]["joints_deg"]
    for name, locator in (("neck tilt", "PRM:/r1/c1-Joint2:j1"),
                          ("left hind 3", "PRM:/r3/c1/c2/c3-Joint2:j3")):
        example.expect(abs(float(angles.get(name, "nan")) - joints[locator]) < 0.11,
                       f"{name} is {joints[locator]}, the page says {angles.get(name)}")
