# Dependencies are built in a layer of their own (cargo-chef), so that a change of the source rebuilds only the source.
FROM rust:1.95-bookworm AS chef
RUN cargo install cargo-chef --locked --version 0.1.72
WORKDIR /src

FROM chef AS plan
COPY . .
RUN cargo chef prepare --recipe-path recipe.json

FROM chef AS build
COPY --from=plan /src/recipe.json recipe.json
RUN cargo chef cook --release --locked --features s3 --bin plateau --recipe-path recipe.json
COPY . .
RUN cargo build --release --locked --features s3 --bin plateau \
    && mkdir -p /image/data /image/usr/local/bin \
    && cp target/release/plateau /image/usr/local/bin/plateau

# No shell, no package manager; the user is 65532. The root file system may be read-only: only /data is written.
FROM gcr.io/distroless/cc-debian12:nonroot
COPY --from=build --chown=65532:65532 /image/ /
ENV PLATEAU_LISTEN=0.0.0.0:8080 PLATEAU_DATA=/data
VOLUME /data
EXPOSE 8080
USER 65532:65532
HEALTHCHECK --interval=10s --timeout=5s --start-period=30s --retries=3 CMD ["/usr/local/bin/plateau", "health"]
ENTRYPOINT ["/usr/local/bin/plateau"]
CMD ["serve"]
