// Compiles and draws with Direct3D 11, for Windows or Wine.
//     direct3d compile                    reads lines "FILE PROFILE FLAGS", compiles each file with FXC, and
//     prints the
//                                         line, the time and, if it failed, the compiler's messages
//     direct3d fxc SHADER.hlsl... VALUES  runs compute shaders that fill 256 x 257 floats, and writes these
//     direct3d angle SHADER.frag VALUES   draws a fragment shader of OpenGL ES with ANGLE, and writes the red
//     channel
// fxc and angle print the version and, after all, "done".

#define GL_GLEXT_PROTOTYPES
#include <GL/gl.h>
#include <GL/glext.h>
#include <d3d11.h>
#include <d3dcompiler.h>
#include <wrl/client.h>

#include <chrono>
#include <cstdlib>
#include <fstream>
#include <iostream>
#include <iterator>
#include <sstream>
#include <vector>

extern "C" { // <EGL/egl.h>, which MinGW lacks
void* eglGetPlatformDisplayEXT(unsigned platform, void* native, const int* attributes);
unsigned eglInitialize(void* display, int* major, int* minor);
unsigned eglChooseConfig(void* display, const int* attributes, void** configs, int size, int* count);
void* eglCreateContext(void* display, void* config, void* share, const int* attributes);
unsigned eglMakeCurrent(void* display, void* draw, void* read, void* context);
unsigned eglTerminate(void* display);
}

namespace {

// Releases devices before the program ends: the threads of one that was still alive made Wine crash now and
// then.
using Microsoft::WRL::ComPtr;

constexpr UINT width = 256, height = 257, size = width * height;

template <class Value>
Value checked(Value good, const char* what) {
    if (!good) {
        std::cerr << what << " failed\n";
        std::exit(1);
    }
    return good;
}

std::string read(const char* path) {
    std::ifstream file(path, std::ios::binary);
    return {std::istreambuf_iterator<char>(file), {}};
}

ComPtr<ID3DBlob> compiled(const char* path, const char* profile, UINT flags, std::ostream& messages) {
    const std::string text = read(path);
    ComPtr<ID3DBlob> code, said;
    const HRESULT result =
        D3DCompile(text.data(), text.size(), path, nullptr, nullptr, "main", profile, flags, 0, &code, &said);
    if (FAILED(result))
        messages << (said ? static_cast<const char*>(said->GetBufferPointer()) : "no message");
    return SUCCEEDED(result) ? code : nullptr;
}

int compile() {
    int failed = 0;
    for (std::string line; std::getline(std::cin, line);) {
        std::istringstream words(line);
        std::string path, profile;
        UINT flags;
        words >> path >> profile >> flags;
        std::ostringstream messages;
        const auto start = std::chrono::steady_clock::now();
        failed |= !compiled(path.c_str(), profile.c_str(), flags, messages);
        const std::chrono::duration<double> time = std::chrono::steady_clock::now() - start;
        std::cout << line << ' ' << time.count() << " s\n" << messages.str() << std::flush;
    }
    return failed;
}

std::vector<float> fxc(const char* path) {
    ComPtr<ID3D11Device> device;
    ComPtr<ID3D11DeviceContext> context;
    checked(SUCCEEDED(D3D11CreateDevice(nullptr, D3D_DRIVER_TYPE_HARDWARE, nullptr, 0, nullptr, 0,
                                        D3D11_SDK_VERSION, &device, nullptr, &context)),
            "D3D11CreateDevice");
    const ComPtr<ID3DBlob> code = checked(compiled(path, "cs_5_0", 0, std::cerr), path);
    D3D11_BUFFER_DESC description = {
        4 * size, D3D11_USAGE_DEFAULT, D3D11_BIND_UNORDERED_ACCESS, 0, D3D11_RESOURCE_MISC_BUFFER_STRUCTURED,
        4};
    ComPtr<ID3D11Buffer> values, staging;
    device->CreateBuffer(&description, nullptr, &values);
    description = {4 * size, D3D11_USAGE_STAGING, 0, D3D11_CPU_ACCESS_READ, 0, 0};
    device->CreateBuffer(&description, nullptr, &staging);
    ComPtr<ID3D11UnorderedAccessView> view;
    device->CreateUnorderedAccessView(values.Get(), nullptr, &view);
    ComPtr<ID3D11ComputeShader> shader;
    device->CreateComputeShader(code->GetBufferPointer(), code->GetBufferSize(), nullptr, &shader);
    context->CSSetShader(shader.Get(), nullptr, 0);
    context->CSSetUnorderedAccessViews(0, 1, view.GetAddressOf(), nullptr);
    context->Dispatch(width / 8, height, 1);
    context->CopyResource(staging.Get(), values.Get());
    D3D11_MAPPED_SUBRESOURCE mapped;
    checked(SUCCEEDED(context->Map(staging.Get(), 0, D3D11_MAP_READ, 0, &mapped)), "Map");
    std::cout << D3DCOMPILER_DLL_A << '\n';
    const auto* floats = static_cast<const float*>(mapped.pData);
    return {floats, floats + size};
}

std::vector<float> angle(const char* path) {
    const int platform[] = {0x3203, 0x3208, 0x3038}, renderable[] = {0x3040, 0x40, 0x3038},
              version[] = {0x3098, 3, 0x3038};
    void *display = eglGetPlatformDisplayEXT(0x3202, nullptr, platform), *config; // ANGLE on Direct3D 11
    int count;
    checked(eglInitialize(display, nullptr, nullptr), "eglInitialize");
    eglChooseConfig(display, renderable, &config, 1, &count);
    void* context = eglCreateContext(display, config, nullptr, version);
    checked(eglMakeCurrent(display, nullptr, nullptr, context), "eglMakeCurrent");

    const std::string texts[] = {read(path), R"(#version 300 es
        void main() { gl_Position = vec4(gl_VertexID == 1 ? 3 : -1, gl_VertexID == 2 ? 3 : -1, 0, 1); })"};
    const GLuint program = glCreateProgram();
    for (const std::string& text : texts) {
        const GLuint shader = glCreateShader(&text == texts ? GL_FRAGMENT_SHADER : GL_VERTEX_SHADER);
        const char* source = text.c_str();
        glShaderSource(shader, 1, &source, nullptr);
        glCompileShader(shader);
        glAttachShader(program, shader);
    }
    glLinkProgram(program);
    std::string messages(1 << 20, '\0');
    glGetProgramInfoLog(program, messages.size(), nullptr, &messages[0]);
    std::cerr << messages.c_str();
    glUseProgram(program);
    GLuint texture, buffer;
    glGenTextures(1, &texture);
    glBindTexture(GL_TEXTURE_2D, texture);
    glTexStorage2D(GL_TEXTURE_2D, 1, GL_RGBA32F, width, height);
    glGenFramebuffers(1, &buffer);
    glBindFramebuffer(GL_FRAMEBUFFER, buffer);
    glFramebufferTexture2D(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_2D, texture, 0);
    glViewport(0, 0, width, height);
    glDrawArrays(GL_TRIANGLES, 0, 3);
    std::vector<float> pixels(4 * size), values(size);
    glReadPixels(0, 0, width, height, GL_RGBA, GL_FLOAT, pixels.data());
    checked(glGetError() == GL_NO_ERROR, "OpenGL ES");
    for (UINT i = 0; i < size; ++i)
        values[i] = pixels[4 * i];
    std::cout << glGetString(GL_VERSION) << '\n' << glGetString(GL_RENDERER) << '\n';
    eglMakeCurrent(display, nullptr, nullptr, nullptr);
    eglTerminate(display);
    return values;
}

} // namespace

int main(int count, char** argv) {
    const std::string mode = argv[1];
    if (mode == "compile")
        return compile();
    std::ofstream file(argv[count - 1], std::ios::binary);
    for (int i = 2; i < count - 1; ++i) {
        const std::vector<float> values = mode == "fxc" ? fxc(argv[i]) : angle(argv[i]);
        file.write(reinterpret_cast<const char*>(values.data()), 4 * size);
    }
    file.close();
    // Wine kills a process whose end takes a second, so that its status says nothing.
    std::cout << "done" << std::endl;
}
