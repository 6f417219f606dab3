# The laboratory on Debian 12, built; running it reproduces the study of the source report's claims:
#   docker build -t mwt .
#   docker run --rm -v "$PWD/results:/mwt/results" mwt             ./reproduce
#   docker run --rm -v "$PWD:/data" -w /data mwt mwt solve points.txt --algorithm exact
FROM debian:12

WORKDIR /mwt
COPY setup/ensure_packages.sh setup/packages.txt setup/
RUN setup/ensure_packages.sh setup/packages.txt && rm -rf /var/lib/apt/lists/*

COPY . .
# The folder's owner outside need not be that of the container; git states the commit all the same.
RUN git config --system --add safe.directory /mwt && \
    setup/build.sh release mwt mwt_verify mwt_benchmark && \
    ln -s /mwt/build/release/mwt /mwt/build/release/mwt_verify /mwt/build/release/mwt_benchmark /usr/local/bin/

CMD ["./reproduce"]
