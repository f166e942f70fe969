class Shaderlint < Formula
  desc "{{summary}}"
  homepage "{{repository}}"
  version "{{version}}"
  license any_of: ["MIT", "Apache-2.0"]

  on_macos do
    on_arm do
      url "#{homepage}/releases/download/v#{version}/shaderlint-#{version}-aarch64-apple-darwin.tar.gz"
      sha256 "{{aarch64-apple-darwin}}"
    end
    on_intel do
      url "#{homepage}/releases/download/v#{version}/shaderlint-#{version}-x86_64-apple-darwin.tar.gz"
      sha256 "{{x86_64-apple-darwin}}"
    end
  end

  on_linux do
    on_arm do
      url "#{homepage}/releases/download/v#{version}/shaderlint-#{version}-aarch64-unknown-linux-gnu.tar.gz"
      sha256 "{{aarch64-unknown-linux-gnu}}"
    end
    on_intel do
      url "#{homepage}/releases/download/v#{version}/shaderlint-#{version}-x86_64-unknown-linux-gnu.tar.gz"
      sha256 "{{x86_64-unknown-linux-gnu}}"
    end
  end

  def install
    bin.install "shaderlint", "shaderport"
    man1.install "man/shaderlint.1", "man/shaderport.1"
    bash_completion.install "completions/shaderlint.bash" => "shaderlint"
    bash_completion.install "completions/shaderport.bash" => "shaderport"
    zsh_completion.install "completions/_shaderlint", "completions/_shaderport"
    fish_completion.install "completions/shaderlint.fish", "completions/shaderport.fish"
  end

  test do
    (testpath/"a.glsl").write "void mainImage(out vec4 c, in vec2 p) { c = 1; }\n"
    assert_match "error[", shell_output("#{bin}/shaderlint a.glsl", 1)
  end
end
