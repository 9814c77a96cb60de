#!/usr/bin/env python3
"""remote_client.py HOST:PORT [MOTION [FILE]]: moves the head, plays MOTION, uploads FILE."""
import pathlib, socket, struct, sys, time, zlib  # the protocol: docs/remote-control.md

INFO, DESCRIBE, MOVE, SENSORS, MTN_PLAY = 0x01, 0x02, 0x11, 0x30, 0x40
MTN_LIST, UPLOAD_BEGIN, UPLOAD_DATA, UPLOAD_END = 0x42, 0x50, 0x51, 0x52  # need version 2
HEAD_PAN, READY = 1, 6  # joint of the ERS-210; state in which the robot stands and plays nothing

def ask(robot, command, payload=b"", version=1):
    robot.write(struct.pack("<2sHBBH", b"RC", 8 + len(payload), version, command, 0) + payload)
    robot.flush()  # the tag may always be 0, because we read each answer before the next request
    if len(header := robot.read(16)) < 16:  # read() waits for all 16; less is the end
        raise ConnectionError("the robot closed the connection")
    size, status = struct.unpack("<2xH8xH2x", header)
    answer = robot.read(size - 16)
    if status:
        raise RuntimeError(f"error {status}: {split_string(answer)[0]}")
    return answer

def split_string(data):  # returns the string that `data` begins with, and the bytes behind it
    return data[1:1 + data[0]].decode("ascii"), data[1 + data[0]:]

def wait_until(robot, is_done):  # is_done(state, positions of the joints in 0.01 degree)
    sensors = ask(robot, SENSORS)
    while not is_done(sensors[5], struct.unpack_from(f"<{sensors[0]}i", sensors, 8)):
        time.sleep(0.032)  # s; the robot has new sensor values every 32 ms
        sensors = ask(robot, SENSORS)

def show(robot):
    info = ask(robot, INFO)
    print(f"{split_string(info[8:])[0]}, {info[0]} joints:")
    for joint in range(info[0]):
        print("  ", joint, split_string(ask(robot, DESCRIBE, bytes([0, joint])))[0])

def move_head(robot, degrees):
    ask(robot, MOVE, struct.pack("<Bi", HEAD_PAN, degrees * 100))  # the answer comes at once
    wait_until(robot, lambda state, joints: abs(joints[HEAD_PAN] / 100 - degrees) < 1)
    print("head pan:", degrees, "degrees")

def list_motions(robot):
    first, total = 0, 1
    while first < total:  # an answer has room for 50 motions
        answer = ask(robot, MTN_LIST, struct.pack("<H", first), version=2)
        (total, _, count), rest = struct.unpack_from("<HHB", answer), answer[5:]
        first += count
        for _ in range(count):
            name, rest = split_string(rest)
            print("  ", name, struct.unpack_from("<I", rest)[0], "bytes")
            rest = rest[4:]

def play(robot, name):
    ask(robot, MTN_PLAY, struct.pack(f"<{len(name) + 1}pHB", name.encode(), 1, 0))  # p: a string
    wait_until(robot, lambda state, joints: state == READY)  # left before the answer came
    print(name, "has ended")

def upload(robot, path):
    data, name = path.read_bytes(), path.name.encode()
    begin = struct.pack(f"<B{len(name) + 1}pII", 0, name, len(data), zlib.crc32(data))
    room = struct.unpack("<H", ask(robot, UPLOAD_BEGIN, begin, version=2))[0]
    for i in range(0, len(data), room):
        ask(robot, UPLOAD_DATA, struct.pack("<I", i) + data[i:i + room], version=2)
    ask(robot, UPLOAD_END, version=2)
    print(path, "is on the robot's stick")

def main(address, motion="", file=""):
    with socket.create_connection(address.rsplit(":", 1), 10) as s, s.makefile("rwb") as robot:
        show(robot)
        wait_until(robot, lambda state, joints: state == READY)  # until then MOVE is refused
        move_head(robot, 30)
        move_head(robot, 0)
        list_motions(robot)
        if motion:
            play(robot, motion)
        if file:
            upload(robot, pathlib.Path(file))

if __name__ == "__main__":
    try:
        main(*(sys.argv[1:] or sys.exit(__doc__)))
    except (OSError, RuntimeError) as error:
        sys.exit(f"remote_client.py: {error}")
