// Drops a file on an X11 window, as a file manager does: drop_file WINDOW PATH. The protocol is XDND 5.

#include <X11/Xatom.h>
#include <X11/Xlib.h>

#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <string>

int main(int argc, char** argv) {
    if (argc != 3)
        return 2;
    Display* display = XOpenDisplay(nullptr);
    if (!display)
        return 1;
    const Window target = std::strtoul(argv[1], nullptr, 0);
    const std::string list = std::string("file://") + argv[2] + "\r\n";
    const Window root = DefaultRootWindow(display);
    const Window source = XCreateSimpleWindow(display, root, 0, 0, 1, 1, 0, 0, 0);
    const auto atom = [&](const char* name) { return XInternAtom(display, name, False); };
    const Atom selection = atom("XdndSelection");
    const Atom uri_list = atom("text/uri-list");
    XSetSelectionOwner(display, selection, source, CurrentTime);
    const auto send = [&](const char* type, long a, long b, long c, long d) {
        XEvent event{};
        event.xclient.type = ClientMessage;
        event.xclient.window = target;
        event.xclient.message_type = atom(type);
        event.xclient.format = 32;
        const long values[] = {static_cast<long>(source), a, b, c, d};
        std::memcpy(event.xclient.data.l, values, sizeof values);
        XSendEvent(display, target, False, NoEventMask, &event);
        XFlush(display);
    };
    send("XdndEnter", 5 << 24, static_cast<long>(uri_list), 0, 0);
    send("XdndPosition", 0, 100 << 16 | 100, CurrentTime, static_cast<long>(atom("XdndActionCopy")));
    for (XEvent event;;) {
        XNextEvent(display, &event);
        if (event.type == ClientMessage && event.xclient.message_type == atom("XdndStatus")) {
            send("XdndDrop", 0, CurrentTime, 0, 0);
        } else if (event.type == ClientMessage && event.xclient.message_type == atom("XdndFinished")) {
            return 0;
        } else if (event.type == SelectionRequest) {
            const XSelectionRequestEvent& request = event.xselectionrequest;
            XChangeProperty(display, request.requestor, request.property, uri_list, 8, PropModeReplace,
                            reinterpret_cast<const unsigned char*>(list.data()),
                            static_cast<int>(list.size()));
            XEvent reply{};
            reply.xselection.type = SelectionNotify;
            reply.xselection.requestor = request.requestor;
            reply.xselection.selection = request.selection;
            reply.xselection.target = request.target;
            reply.xselection.property = request.property;
            reply.xselection.time = request.time;
            XSendEvent(display, request.requestor, False, NoEventMask, &reply);
            XFlush(display);
        }
    }
}
